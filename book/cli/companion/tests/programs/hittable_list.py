class hit_record:
    pass

class sphere:
    def __init__(self, center, radius):
        self.center, self.radius = center, radius

    def hit(self, r, t_min, t_max):
        oc = self.center - r.origin
        a = dot(r.direction, r.direction)
        h = dot(r.direction, oc)
        c = dot(oc, oc) - self.radius * self.radius
        discriminant = h * h - a * c
        if discriminant < 0:
            return None
        sqrtd = math.sqrt(discriminant)
        root = (h - sqrtd) / a
        if root <= t_min or t_max <= root:
            root = (h + sqrtd) / a
            if root <= t_min or t_max <= root:
                return None
        rec = hit_record()
        rec.t = root
        rec.p = r.at(root)
        outward_normal = (rec.p - self.center) / self.radius
        rec.front_face = dot(r.direction, outward_normal) < 0
        rec.normal = outward_normal if rec.front_face else -outward_normal
        return rec

class hittable_list:
    def __init__(self, objects):
        self.objects = objects

    def hit(self, r, t_min, t_max):
        closest = None
        closest_so_far = t_max
        for o in self.objects:
            rec = o.hit(r, t_min, closest_so_far)
            if rec:
                closest_so_far = rec.t
                closest = rec
        return closest

world = hittable_list([sphere(vec3(0, 0, -1), 0.5), sphere(vec3(0, -100.5, -1), 100)])

def ray_color(r):
    rec = world.hit(r, 0, math.inf)
    if rec:
        return 0.5 * (rec.normal + vec3(1, 1, 1))
    return sky(r)

