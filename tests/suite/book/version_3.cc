// The first chapters of the book as its version 3 has them, after its listings and in its order of
// operations:
//
//     version_3 CHAPTER WIDTH
//
// prints the picture as P3.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

struct vec3 {
    double x, y, z;
};
vec3 operator+(vec3 u, vec3 v) {
    return {u.x + v.x, u.y + v.y, u.z + v.z};
}
vec3 operator-(vec3 u, vec3 v) {
    return {u.x - v.x, u.y - v.y, u.z - v.z};
}
vec3 scaled(double t, vec3 v) {
    return {t * v.x, t * v.y, t * v.z};
}
vec3 divided(vec3 v, double t) { return scaled(1 / t, v); }
double dot(vec3 u, vec3 v) {
    return u.x * v.x + u.y * v.y + u.z * v.z;
}
vec3 unit_vector(vec3 v) {
    return divided(v, std::sqrt(dot(v, v)));
}
struct ray {
    vec3 origin, direction;
    vec3 at(double t) const { return origin + scaled(t, direction); }
};
struct sphere {
    vec3 center;
    double radius;
};

// -1 for a miss. From `normals` on a root is asked for, before only whether there is one.
double hit_sphere(const sphere& ball, const ray& r) {
    auto oc = r.origin - ball.center;
    double a = dot(r.direction, r.direction);
    double b = 2.0 * dot(oc, r.direction);
    double c = dot(oc, oc) - ball.radius * ball.radius;
    double discriminant = b * b - 4 * a * c;
    if (discriminant < 0)
        return -1;
    return (-b - std::sqrt(discriminant)) / (2.0 * a);
}

// The root in the range, the nearer one first; 0 for a miss.
double hit(const sphere& ball, const ray& r, double t_min, double t_max) {
    auto oc = r.origin - ball.center;
    double a = dot(r.direction, r.direction);
    double half_b = dot(oc, r.direction);
    double c = dot(oc, oc) - ball.radius * ball.radius;
    double discriminant = half_b * half_b - a * c;
    if (discriminant < 0)
        return 0;
    double sqrtd = std::sqrt(discriminant);
    for (double root : {(-half_b - sqrtd) / a, (-half_b + sqrtd) / a})
        if (t_min < root && root < t_max)
            return root;
    return 0;
}

vec3 from_normal(vec3 n) {
    return scaled(0.5, vec3{n.x + 1, n.y + 1, n.z + 1});
}

vec3 ray_color(const std::string& chapter, const ray& r) {
    const sphere ball = {{0, 0, -1}, 0.5};
    if (chapter == "red_sphere" && hit_sphere(ball, r) != -1)
        return {1, 0, 0};
    if (chapter == "normals" || chapter == "half_b_sphere") {
        double t = hit_sphere(ball, r);
        if (t > 0)
            return from_normal(unit_vector(r.at(t) - ball.center));
    }
    if (chapter == "hittable_list") {
        const sphere world[] = {ball, {{0, -100.5, -1}, 100}};
        double closest = std::numeric_limits<double>::max();
        vec3 normal;
        bool anything = false;
        for (const auto& object : world) {
            double t = hit(object, r, 0, closest);
            if (t > 0) {
                anything = true;
                closest = t;
                normal = divided(r.at(t) - object.center, object.radius);
            }
        }
        if (anything)
            return from_normal(normal);
    }
    double t = 0.5 * (unit_vector(r.direction).y + 1.0);
    return scaled(1.0 - t, vec3{1, 1, 1})
         + scaled(t, vec3{0.5, 0.7, double(1.0)});
}

int main(int, char** argv) {
    const std::string chapter = argv[1];
    const int image_width = std::atoi(argv[2]);
    const bool is_build_test = chapter == "build_test";
    const auto aspect_ratio = 16.0 / 9.0;
    const int image_height = is_build_test ? image_width : static_cast<int>(image_width / aspect_ratio);
    auto viewport_height = 2.0;
    auto viewport_width = aspect_ratio * viewport_height;
    auto focal_length = 1.0;
    vec3 origin = {0, 0, 0};
    vec3 horizontal = {viewport_width, 0, 0}, vertical = {0, viewport_height, 0};
    auto lower_left_corner =
        origin - divided(horizontal, 2) - divided(vertical, 2) - vec3{0, 0, focal_length};

    std::cout << "P3\n" << image_width << ' ' << image_height << "\n255\n";
    for (int j = image_height - 1; j >= 0; --j) {
        for (int i = 0; i < image_width; ++i) {
            auto u = double(i) / (image_width - 1);
            auto v = double(j) / (image_height - 1);
            vec3 color = {u, v, 0.25};
            if (!is_build_test) {
                auto point = lower_left_corner + scaled(u, horizontal) + scaled(v, vertical);
                color = ray_color(chapter, ray{origin, point - origin});
            }
            std::cout << int(255.999 * color.x) << ' ' << int(255.999 * color.y) << ' '
                      << int(255.999 * color.z) << '\n';
        }
    }
}
