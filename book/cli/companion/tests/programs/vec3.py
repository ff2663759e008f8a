import math

class vec3:
    def __init__(self, x, y, z):
        self.x, self.y, self.z = x, y, z

    def __add__(self, v):
        return vec3(self.x + v.x, self.y + v.y, self.z + v.z)

    def __sub__(self, v):
        return vec3(self.x - v.x, self.y - v.y, self.z - v.z)

    def __mul__(self, t):
        return vec3(t * self.x, t * self.y, t * self.z)

    __rmul__ = __mul__

    def __truediv__(self, t):
        return (1 / t) * self

    def __neg__(self):
        return vec3(-self.x, -self.y, -self.z)

def dot(u, v):
    return u.x * v.x + u.y * v.y + u.z * v.z

def unit_vector(v):
    return v / math.sqrt(dot(v, v))

class ray:
    def __init__(self, origin, direction):
        self.origin, self.direction = origin, direction

    def at(self, t):
        return self.origin + t * self.direction

def sky(r):
    unit_direction = unit_vector(r.direction)
    a = 0.5 * (unit_direction.y + 1.0)
    return (1.0 - a) * vec3(1.0, 1.0, 1.0) + a * vec3(0.5, 0.7, 1.0)

