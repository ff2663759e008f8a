aspect_ratio = 16.0 / 9.0
image_width = 64
image_height = int(image_width / aspect_ratio)
image_height = 1 if image_height < 1 else image_height

focal_length = 1.0
viewport_height = 2.0
viewport_width = viewport_height * (image_width / image_height)
camera_center = vec3(0, 0, 0)
viewport_u = vec3(viewport_width, 0, 0)
viewport_v = vec3(0, -viewport_height, 0)
pixel_delta_u = viewport_u / image_width
pixel_delta_v = viewport_v / image_height
viewport_upper_left = camera_center - vec3(0, 0, focal_length) - viewport_u / 2 - viewport_v / 2
pixel00_loc = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v)

print("P3")
print(image_width, image_height)
print(255)
for j in range(image_height):
    for i in range(image_width):
        pixel_center = pixel00_loc + (i * pixel_delta_u) + (j * pixel_delta_v)
        r = ray(camera_center, pixel_center - camera_center)
        color = ray_color(r)
        print(int(255.999 * color.x), int(255.999 * color.y), int(255.999 * color.z))
