def hit_sphere(center, radius, r):
    oc = center - r.origin
    a = dot(r.direction, r.direction)
    b = -2.0 * dot(r.direction, oc)
    c = dot(oc, oc) - radius * radius
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return None
    return (-b - math.sqrt(discriminant)) / (2.0 * a)

def ray_color(r):
    t = hit_sphere(vec3(0, 0, -1), 0.5, r)
    if t is not None and t > 0:
        n = unit_vector(r.at(t) - vec3(0, 0, -1))
        return 0.5 * vec3(n.x + 1, n.y + 1, n.z + 1)
    return sky(r)

