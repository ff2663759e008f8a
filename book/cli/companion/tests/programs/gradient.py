import math

width, height = 64, 36
viewport = 2.0 * (width / height)
du, dv = viewport * (1.0 / width), -2.0 * (1.0 / height)
x0 = -0.5 * viewport + 0.5 * du
y0 = 0.5 * 2.0 + 0.5 * dv
print("P3", width, height, 255)
for j in range(height):
    for i in range(width):
        x, y, z = x0 + i * du, y0 + j * dv, -1.0
        y = y * (1.0 / math.sqrt(x * x + y * y + z * z))
        a = 0.5 * (y + 1.0)
        red = (1 - a) * 1 + a * 0.5
        green = (1 - a) * 1 + a * 0.7
        blue = (1 - a) * 1 + a * 1
        print(int(255.999 * red), int(255.999 * green), int(255.999 * blue))
