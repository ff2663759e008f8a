// The five chapters in C++, in the book's manner: doubles, virtual calls, shared
// pointers, std::cout. It draws the bytes that the Rust chapters must draw, and
// runs the race against them (`cargo bench -p measure --bench race`).
//
//     g++ -std=c++17 -O3 -o book book/measure/rival/book.cc
//     ./book hittable_list 400 > picture.ppm
//     ./book hittable_list 400 sum       (keeps the bytes, and prints nothing but their sum)

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

struct vec3 {
    double x, y, z;
    double length_squared() const { return x * x + y * y + z * z; }
};
using point3 = vec3;
using color = vec3;

inline vec3 operator-(const vec3& v) { return {-v.x, -v.y, -v.z}; }
inline vec3 operator+(const vec3& u, const vec3& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
inline vec3 operator-(const vec3& u, const vec3& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
inline vec3 operator*(double t, const vec3& v) { return {t * v.x, t * v.y, t * v.z}; }
inline vec3 operator/(const vec3& v, double t) { return (1 / t) * v; }
inline double dot(const vec3& u, const vec3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
inline vec3 unit_vector(const vec3& v) { return v / std::sqrt(v.length_squared()); }

struct ray {
    point3 origin;
    vec3 direction;
    point3 at(double t) const { return origin + t * direction; }
};

color sky(const ray& r) {
    double a = 0.5 * (unit_vector(r.direction).y + 1.0);
    return (1.0 - a) * color{1.0, 1.0, 1.0} + a * color{0.5, 0.7, 1.0};
}

// Chapters 2 to 4: one sphere.

const point3 center{0, 0, -1};
const double radius = 0.5;

color normal_color(const ray& r, double t) {
    vec3 n = unit_vector(r.at(t) - center);
    return 0.5 * color{n.x + 1, n.y + 1, n.z + 1};
}

color red_sphere(const ray& r) {
    vec3 oc = center - r.origin;
    double a = dot(r.direction, r.direction);
    double b = -2.0 * dot(r.direction, oc);
    double c = dot(oc, oc) - radius * radius;
    return b * b - 4 * a * c >= 0 ? color{1, 0, 0} : sky(r);
}

double hit_sphere_with_b(const ray& r) {
    vec3 oc = center - r.origin;
    double a = dot(r.direction, r.direction);
    double b = -2.0 * dot(r.direction, oc);
    double c = dot(oc, oc) - radius * radius;
    double discriminant = b * b - 4 * a * c;
    return discriminant < 0 ? -1.0 : (-b - std::sqrt(discriminant)) / (2.0 * a);
}

color normals(const ray& r) {
    double t = hit_sphere_with_b(r);
    return t > 0.0 ? normal_color(r, t) : sky(r);
}

double hit_sphere_with_h(const ray& r) {
    vec3 oc = center - r.origin;
    double a = r.direction.length_squared();
    double h = dot(r.direction, oc);
    double c = oc.length_squared() - radius * radius;
    double discriminant = h * h - a * c;
    return discriminant < 0 ? -1.0 : (h - std::sqrt(discriminant)) / a;
}

color half_b_sphere(const ray& r) {
    double t = hit_sphere_with_h(r);
    return t > 0.0 ? normal_color(r, t) : sky(r);
}

// Chapter 5: a list.

struct hit_record {
    point3 p;
    vec3 normal;
    double t;
    bool front_face;

    void set_face_normal(const ray& r, const vec3& outward_normal) {
        front_face = dot(r.direction, outward_normal) < 0;
        normal = front_face ? outward_normal : -outward_normal;
    }
};

struct hittable {
    virtual ~hittable() = default;
    virtual bool hit(const ray& r, double t_min, double t_max, hit_record& rec) const = 0;
};

struct sphere : hittable {
    point3 center;
    double radius;

    sphere(const point3& center, double radius) : center(center), radius(std::fmax(0, radius)) {}

    bool hit(const ray& r, double t_min, double t_max, hit_record& rec) const override {
        vec3 oc = center - r.origin;
        double a = r.direction.length_squared();
        double h = dot(r.direction, oc);
        double c = oc.length_squared() - radius * radius;
        double discriminant = h * h - a * c;
        if (discriminant < 0) return false;
        double sqrtd = std::sqrt(discriminant);

        double root = (h - sqrtd) / a;
        if (root <= t_min || t_max <= root) {
            root = (h + sqrtd) / a;
            if (root <= t_min || t_max <= root) return false;
        }
        rec.t = root;
        rec.p = r.at(root);
        rec.set_face_normal(r, (rec.p - center) / radius);
        return true;
    }
};

struct hittable_list final : hittable {
    std::vector<std::shared_ptr<hittable>> objects;

    bool hit(const ray& r, double t_min, double t_max, hit_record& rec) const override {
        hit_record temp_rec;
        bool hit_anything = false;
        double closest_so_far = t_max;
        for (const auto& object : objects) {
            if (object->hit(r, t_min, closest_so_far, temp_rec)) {
                hit_anything = true;
                closest_so_far = temp_rec.t;
                rec = temp_rec;
            }
        }
        return hit_anything;
    }
};

color ray_color(const ray& r, const hittable_list& world) {
    hit_record rec;
    if (world.hit(r, 0, std::numeric_limits<double>::infinity(), rec))
        return 0.5 * (rec.normal + color{1, 1, 1});
    return sky(r);
}

template <typename RayColor, typename WriteColor>
void render(int width, int height, RayColor ray_color, WriteColor write_color) {
    double viewport_height = 2.0;
    double viewport_width = viewport_height * (double(width) / height);
    point3 camera_center{0, 0, 0};
    vec3 viewport_u{viewport_width, 0, 0};
    vec3 viewport_v{0, -viewport_height, 0};
    vec3 pixel_delta_u = viewport_u / width;
    vec3 pixel_delta_v = viewport_v / height;
    point3 upper_left = camera_center - vec3{0, 0, 1.0} - viewport_u / 2 - viewport_v / 2;
    point3 pixel00 = upper_left + 0.5 * (pixel_delta_u + pixel_delta_v);

    for (int j = 0; j < height; j++) {
        for (int i = 0; i < width; i++) {
            point3 pixel_center = pixel00 + double(i) * pixel_delta_u + double(j) * pixel_delta_v;
            color c = ray_color(ray{camera_center, pixel_center - camera_center});
            write_color(int(255.999 * c.x), int(255.999 * c.y), int(255.999 * c.z));
        }
    }
}

template <typename RayColor>
void draw(int width, bool only_sum, RayColor ray_color) {
    int height = std::max(1, int(width / (16.0 / 9.0)));
    if (only_sum) {
        std::vector<unsigned char> bytes(3 * std::size_t(width) * height);
        unsigned char* next = bytes.data();
        render(width, height, ray_color, [&](int r, int g, int b) {
            *next++ = r;
            *next++ = g;
            *next++ = b;
        });
        std::cout << std::accumulate(bytes.begin(), bytes.end(), 0L) << '\n';
        return;
    }
    std::cout << "P3\n" << width << ' ' << height << "\n255\n";
    render(width, height, ray_color,
           [](int r, int g, int b) { std::cout << r << ' ' << g << ' ' << b << '\n'; });
}

int main(int argc, char** argv) {
    std::string stage = argc > 1 ? argv[1] : "";
    int width = argc > 2 ? std::atoi(argv[2]) : 400;
    bool only_sum = argc > 3 && std::string(argv[3]) == "sum";

    hittable_list world;
    world.objects.push_back(std::make_shared<sphere>(point3{0, 0, -1}, 0.5));
    world.objects.push_back(std::make_shared<sphere>(point3{0, -100.5, -1}, 100));

    // Lambdas, because the compiler sees through them; a function would be called.
    if (stage == "gradient")
        draw(width, only_sum, [](const ray& r) { return sky(r); });
    else if (stage == "red_sphere")
        draw(width, only_sum, [](const ray& r) { return red_sphere(r); });
    else if (stage == "normals")
        draw(width, only_sum, [](const ray& r) { return normals(r); });
    else if (stage == "half_b_sphere")
        draw(width, only_sum, [](const ray& r) { return half_b_sphere(r); });
    else if (stage == "hittable_list")
        draw(width, only_sum, [&](const ray& r) { return ray_color(r, world); });
    else {
        std::cerr << "usage: book gradient|red_sphere|normals|half_b_sphere|hittable_list [WIDTH] [sum]\n";
        return 2;
    }
}
