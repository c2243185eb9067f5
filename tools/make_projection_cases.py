#!/usr/bin/env python3
"""Makes tests/sensor/data/frame_projection.csv: places in frames of random cameras, by OpenCV.

OpenCV's projectPoints knows the lens model in the same form and order of coefficients (k1, k2, p1,
p2, k3) and shares no code with Nadir. Cameras stand anywhere from half a metre to 36,000 km from
what they see, turned at random, with lenses from none to strong distortion; their image is where
Nadir's convention has it: (0.5, 0.5) is the centre of the first pixel.

    python3 -m venv venv && venv/bin/pip install opencv-python-headless==5.0.0.93 numpy
    venv/bin/python tools/make_projection_cases.py > tests/sensor/data/frame_projection.csv

The cases of the pushbroom come from tools/RuggedCases.java.
"""

import cv2
import numpy as np

CAMERAS, PLACES = 24, 14
COLUMNS = ("camera,focal_m,k1,k2,p1,p2,k3,pitch_x_m,pitch_y_m,samples,lines,offset_x_m,offset_y_m,"
           "position_x,position_y,position_z,"
           "axis_x_x,axis_x_y,axis_x_z,axis_y_x,axis_y_y,axis_y_z,axis_z_x,axis_z_y,axis_z_z,"
           "place_x,place_y,place_z,sample,line")


def random_rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def folds(coefficients, reach):
    """Whether the radial part turns back, or the tangential part could, with some margin."""
    k1, k2, p1, p2, k3 = coefficients
    r = np.linspace(0.0, 1.6 * reach, 400)
    slope = 1 + 3 * k1 * r**2 + 5 * k2 * r**4 + 7 * k3 * r**6
    ratio = 1 + k1 * r**2 + k2 * r**4 + k3 * r**6
    slack = 8 * (abs(p1) + abs(p2)) * r
    return np.any(slope < 0.15 + slack) or np.any(ratio < 0.15 + slack) or np.any(
        r[-1] * ratio[-1] < reach)


def random_camera(rng, number):
    while True:
        reach = rng.uniform(0.02, 0.7)  # of the image's corner over the focal length
        k1, k2, k3 = rng.uniform(-1, 1, 3) * (0.4, 0.15, 0.05)
        p1, p2 = rng.uniform(-1, 1, 2) * 0.004
        coefficients = np.array([k1, k2, p1, p2, k3]) * (0.0 if number == 0 else 1.0)
        if not folds(coefficients, reach * 1.3):
            break
    samples, lines = (int(n) for n in rng.integers(200, 6000, 2))
    pitch_x = rng.uniform(2e-6, 4e-5)
    pitch_y = pitch_x * (rng.uniform(0.7, 1.4) if number % 3 == 0 else 1.0)
    focal = 0.5 * np.hypot(samples * pitch_x, lines * pitch_y) / reach
    offset = rng.uniform(-0.1, 0.1, 2) * focal * reach
    return {"focal": focal, "coefficients": coefficients, "pitch": (pitch_x, pitch_y),
            "size": (samples, lines), "offset": offset, "axes": random_rotation(rng),
            "distance": 10 ** rng.uniform(np.log10(0.5), np.log10(3.6e7))}


def places_of(rng, camera):
    """Places that OpenCV finds inside the image, where it finds them."""
    pitch, size = np.array(camera["pitch"]), np.array(camera["size"])
    scale = camera["focal"] / pitch
    centre = 0.5 * size - camera["offset"] / pitch
    matrix = np.array([[scale[0], 0, centre[0]], [0, scale[1], centre[1]], [0, 0, 1]])
    position = rng.normal(size=3) * camera["distance"]
    # As few roundings as can be: OpenCV gets the vector from the camera, its own translation is 0.
    turn = cv2.Rodrigues(camera["axes"].T)[0]
    half = (0.5 * size * pitch + np.abs(camera["offset"])) / camera["focal"] * 1.2
    rows = []
    while len(rows) < PLACES:
        seen = np.array([*(rng.uniform(-1, 1, 2) * half), 1.0])
        place = position + camera["axes"] @ seen * camera["distance"] * rng.uniform(0.5, 2.0)
        offset = (place - position).reshape(1, 3)
        image = cv2.projectPoints(offset, turn, np.zeros(3), matrix, camera["coefficients"])[0]
        image = image.reshape(2)
        if np.all(image > 0) and np.all(image < size):
            rows.append((position, place, image))
    return rows


def main():
    rng = np.random.default_rng(20260801)
    print(f"# tools/make_projection_cases.py with OpenCV {cv2.__version__} (Apache License 2.0)")
    print(COLUMNS)
    for number in range(CAMERAS):
        camera = random_camera(rng, number)
        for position, place, image in places_of(rng, camera):
            lens = [camera["focal"], *camera["coefficients"], *camera["pitch"]]
            numbers = [*camera["offset"], *position, *camera["axes"].T.ravel(), *place, *image]
            cells = [str(number), *(repr(float(v)) for v in lens),
                     *(str(n) for n in camera["size"]), *(repr(float(v)) for v in numbers)]
            print(",".join(cells))


if __name__ == "__main__":
    main()
