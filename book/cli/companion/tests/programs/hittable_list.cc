class hit_record {
  public:
    vec3 p;
    vec3 normal;
    double t;
    bool front_face;

    void set_face_normal(const ray& r, const vec3& outward_normal) {
        front_face = dot(r.direction(), outward_normal) < 0;
        normal = front_face ? outward_normal : -outward_normal;
    }
};

class interval {
  public:
    double min, max;
    interval(double min, double max) : min(min), max(max) {}
    bool surrounds(double x) const { return min < x && x < max; }
};

class hittable {
  public:
    virtual ~hittable() = default;
    virtual bool hit(const ray& r, interval ray_t, hit_record& rec) const = 0;
};

class sphere : public hittable {
  public:
    sphere(const vec3& center, double radius) : center(center), radius(std::fmax(0,radius)) {}

    bool hit(const ray& r, interval ray_t, hit_record& rec) const override {
        vec3 oc = center - r.origin();
        auto a = dot(r.direction(), r.direction());
        auto h = dot(r.direction(), oc);
        auto c = dot(oc, oc) - radius*radius;
        auto discriminant = h*h - a*c;
        if (discriminant < 0)
            return false;
        auto sqrtd = std::sqrt(discriminant);
        auto root = (h - sqrtd) / a;
        if (!ray_t.surrounds(root)) {
            root = (h + sqrtd) / a;
            if (!ray_t.surrounds(root))
                return false;
        }
        rec.t = root;
        rec.p = r.at(rec.t);
        vec3 outward_normal = (rec.p - center) / radius;
        rec.set_face_normal(r, outward_normal);
        return true;
    }

  private:
    vec3 center;
    double radius;
};

class hittable_list : public hittable {
  public:
    std::vector<std::shared_ptr<hittable>> objects;

    bool hit(const ray& r, interval ray_t, hit_record& rec) const override {
        hit_record temp_rec;
        bool hit_anything = false;
        auto closest_so_far = ray_t.max;
        for (const auto& object : objects) {
            if (object->hit(r, interval(ray_t.min, closest_so_far), temp_rec)) {
                hit_anything = true;
                closest_so_far = temp_rec.t;
                rec = temp_rec;
            }
        }
        return hit_anything;
    }
};

vec3 ray_color(const ray& r) {
    hittable_list world;
    world.objects.push_back(std::make_shared<sphere>(vec3(0,0,-1), 0.5));
    world.objects.push_back(std::make_shared<sphere>(vec3(0,-100.5,-1), 100));
    hit_record rec;
    if (world.hit(r, interval(0, std::numeric_limits<double>::infinity()), rec)) {
        return 0.5 * (rec.normal + vec3(1,1,1));
    }
    return sky(r);
}

