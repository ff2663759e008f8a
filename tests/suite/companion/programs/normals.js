class vec3 {
  constructor(x, y, z) { this.x = x; this.y = y; this.z = z; }
  minus(v) { return new vec3(this.x - v.x, this.y - v.y, this.z - v.z); }
}
class ray {
  constructor(origin, direction) { this.origin = origin; this.direction = direction; }
}
const dot = (u, v) => u.x * v.x + u.y * v.y + u.z * v.z;

function hit_sphere(center, radius, r) {
  const oc = center.minus(r.origin);
  const a = dot(r.direction, r.direction);
  const b = -2 * dot(r.direction, oc);
  const c = dot(oc, oc) - radius * radius;
  const discriminant = b * b - 4 * a * c;
  return discriminant < 0 ? null : (-b - Math.sqrt(discriminant)) / (2 * a);
}

