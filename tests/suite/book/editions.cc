// The first chapters of the book as its editions before version 4 have them, after their
// listings and in their order of operations:
//
//     editions EDITION CHAPTER WIDTH
//
// prints the picture as P3. Version 1 computes in float; `1-in-double` is the same with
// `using real = double`, and with the vector class of version 3.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

struct edition {
    bool two_to_one;     // 200 x 100, u = i / nx
    double factor;       // of a level
    double blue;         // of the build test
    bool is_3_1_0;       // viewport 4 x 2.25, for the list 4 x 2
};

template <typename real> struct vec3 {
    real x, y, z;
};
template <typename real> vec3<real> operator+(vec3<real> u, vec3<real> v) {
    return {u.x + v.x, u.y + v.y, u.z + v.z};
}
template <typename real> vec3<real> operator-(vec3<real> u, vec3<real> v) {
    return {u.x - v.x, u.y - v.y, u.z - v.z};
}
template <typename real> vec3<real> scaled(real t, vec3<real> v) {
    return {t * v.x, t * v.y, t * v.z};
}
// Version 1 divides each component, version 3 multiplies by the reciprocal.
vec3<float> divided(vec3<float> v, float t) { return {v.x / t, v.y / t, v.z / t}; }
vec3<double> divided(vec3<double> v, double t) { return scaled(1 / t, v); }
template <typename real> real dot(vec3<real> u, vec3<real> v) {
    return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <typename real> vec3<real> unit_vector(vec3<real> v) {
    return divided(v, real(std::sqrt(dot(v, v))));
}
template <typename real> struct ray {
    vec3<real> origin, direction;
    vec3<real> at(real t) const { return origin + scaled(t, direction); }
};
template <typename real> struct sphere {
    vec3<real> center;
    real radius;
};

// -1 for a miss. From `normals` on a root is asked for, before only whether there is one.
template <typename real> real hit_sphere(const sphere<real>& ball, const ray<real>& r) {
    auto oc = r.origin - ball.center;
    real a = dot(r.direction, r.direction);
    real b = 2.0 * dot(oc, r.direction);
    real c = dot(oc, oc) - ball.radius * ball.radius;
    real discriminant = b * b - 4 * a * c;
    if (discriminant < 0)
        return -1;
    return (-b - std::sqrt(discriminant)) / (2.0 * a);
}

// The root in the range, the nearer one first; 0 for a miss.
template <typename real>
real hit(const sphere<real>& ball, const ray<real>& r, real t_min, real t_max) {
    auto oc = r.origin - ball.center;
    real a = dot(r.direction, r.direction);
    real half_b = dot(oc, r.direction);
    real c = dot(oc, oc) - ball.radius * ball.radius;
    real discriminant = half_b * half_b - a * c;
    if (discriminant < 0)
        return 0;
    real sqrtd = std::sqrt(discriminant);
    for (real root : {real((-half_b - sqrtd) / a), real((-half_b + sqrtd) / a)})
        if (t_min < root && root < t_max)
            return root;
    return 0;
}

template <typename real> vec3<real> from_normal(vec3<real> n) {
    return scaled(real(0.5), vec3<real>{n.x + 1, n.y + 1, n.z + 1});
}

template <typename real> vec3<real> ray_color(const std::string& chapter, const ray<real>& r) {
    const sphere<real> ball = {{0, 0, -1}, real(0.5)};
    if (chapter == "red_sphere" && hit_sphere(ball, r) != -1)
        return {1, 0, 0};
    if (chapter == "normals" || chapter == "half_b_sphere") {
        real t = hit_sphere(ball, r);
        if (t > 0)
            return from_normal(unit_vector(r.at(t) - ball.center));
    }
    if (chapter == "hittable_list") {
        const sphere<real> world[] = {ball, {{0, real(-100.5), -1}, 100}};
        real closest = std::numeric_limits<real>::max();
        vec3<real> normal;
        bool anything = false;
        for (const auto& object : world) {
            real t = hit(object, r, real(0), closest);
            if (t > 0) {
                anything = true;
                closest = t;
                normal = divided(r.at(t) - object.center, object.radius);
            }
        }
        if (anything)
            return from_normal(normal);
    }
    real t = 0.5 * (unit_vector(r.direction).y + 1.0);
    return scaled(real(1.0 - t), vec3<real>{1, 1, 1})
         + scaled(t, vec3<real>{real(0.5), real(0.7), real(1.0)});
}

template <typename real>
void print(const edition& book, const std::string& chapter, int width) {
    const bool is_build_test = chapter == "build_test";
    const double aspect_ratio = 16.0 / 9.0;
    const int height = book.two_to_one ? width / 2
                     : is_build_test   ? width
                                       : static_cast<int>(width / aspect_ratio);
    const int columns = book.two_to_one ? width : width - 1;
    const int rows = book.two_to_one ? height : height - 1;
    real across = aspect_ratio * 2.0, up = 2;
    if (book.two_to_one || book.is_3_1_0)
        across = 4;
    if (book.is_3_1_0 && chapter != "hittable_list")
        up = 2.25;
    const vec3<real> horizontal = {across, 0, 0}, vertical = {0, up, 0};
    const vec3<real> lower_left_corner = {-across / 2, -up / 2, -1};

    std::cout << "P3\n" << width << ' ' << height << "\n255\n";
    for (int j = height - 1; j >= 0; --j) {
        for (int i = 0; i < width; ++i) {
            real u = real(i) / columns;
            real v = real(j) / rows;
            vec3<real> color = {u, v, real(book.blue)};
            if (!is_build_test) {
                auto point = lower_left_corner + scaled(u, horizontal) + scaled(v, vertical);
                color = ray_color(chapter, ray<real>{{0, 0, 0}, point});
            }
            std::cout << int(book.factor * color.x) << ' ' << int(book.factor * color.y) << ' '
                      << int(book.factor * color.z) << '\n';
        }
    }
}

int main(int, char** argv) {
    const std::string name = argv[1], chapter = argv[2];
    const int width = std::atoi(argv[3]);
    if (name == "1")
        print<float>({true, 255.99, 0.2, false}, chapter, width);
    if (name == "1-in-double")
        print<double>({true, 255.99, 0.2, false}, chapter, width);
    if (name == "3.0")
        print<double>({true, 255.999, 0.2, false}, chapter, width);
    if (name == "3.1.0")
        print<double>({false, 255.999, 0.25, true}, chapter, width);
    if (name == "3")
        print<double>({false, 255.999, 0.25, false}, chapter, width);
}
