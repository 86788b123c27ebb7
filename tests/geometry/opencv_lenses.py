#!/usr/bin/env python3
"""tests/geometry/opencv_lenses.py: where OpenCV projects points behind random lenses.

Prints the table opencv_lenses.csv, which lens_test.cpp holds sightline to; with --check compares the table with what OpenCV
says here (exit code 77 where there is no OpenCV). A row: model, image width and height, fx, fy, cx, cy, eight coefficients as
sightline has them (brown: k1 to k6, p1, p2; fisheye: k1 to k4), the point in the camera's frame, and its pixel, where (0, 0) is
the first pixel's centre."""

import csv
import pathlib
import random
import sys

TABLE = pathlib.Path(__file__).resolve().parent / "opencv_lenses.csv"
HEADER = "model,width,height,fx,fy,cx,cy,c1,c2,c3,c4,c5,c6,c7,c8,x,y,z,pixel_x,pixel_y".split(",")


def brown(rng, size):
    small = size in (4, 5)
    k = [rng.uniform(-0.3, 0.3), rng.uniform(-0.1, 0.1), rng.uniform(-0.02, 0.02)]
    more = [0.0] * 3 if small else [rng.uniform(-0.05, 0.05) for _ in range(3)]
    if size == 4:
        k[2] = 0.0
    return k + more + [rng.uniform(-0.003, 0.003) for _ in range(2)]


def projected(cv2, numpy, row):
    model, (fx, fy, cx, cy), c, point = row[0], row[3:7], row[7:15], row[15:18]
    k = numpy.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
    points = numpy.array([[point]], dtype=float)
    zero = numpy.zeros(3)
    if model == "fisheye":
        pixels, _ = cv2.fisheye.projectPoints(points, zero, zero, k, numpy.array(c[:4]))
    else:
        order = [c[0], c[1], c[6], c[7], c[2], c[3], c[4], c[5]]
        pixels, _ = cv2.projectPoints(points, zero, zero, k, numpy.array(order))
    return [float(v) for v in pixels.reshape(2)]


def inputs():
    rng = random.Random(20261130)
    rows = []
    for lens in range(60):
        is_fisheye = lens % 3 == 2
        width, height = rng.randrange(320, 5000), rng.randrange(240, 4000)
        f = width * rng.uniform(0.5, 2)
        camera = [width, height, f, f * rng.uniform(0.95, 1.05), width * rng.uniform(0.4, 0.6), height * rng.uniform(0.4, 0.6)]
        c = [rng.uniform(-0.05, 0.05) for _ in range(4)] + [0.0] * 4 if is_fisheye else brown(rng, rng.choice([4, 5, 8]))
        for _ in range(5):
            z = rng.uniform(0.5, 20)
            reach = 1.5 if is_fisheye else 0.7
            point = [rng.uniform(-reach, reach) * z, rng.uniform(-reach, reach) * z, z]
            rows.append(["fisheye" if is_fisheye else "brown"] + camera + c + point)
    return rows


def main():
    try:
        import cv2
        import numpy
    except ImportError:
        print("no OpenCV here: install python3-opencv")
        return 77
    rows = [row + projected(cv2, numpy, row) for row in inputs()]
    if "--check" not in sys.argv:
        writer = csv.writer(sys.stdout, lineterminator="\n")
        writer.writerow(HEADER)
        writer.writerows([[v if isinstance(v, (str, int)) else repr(v) for v in row] for row in rows])
        return 0
    with TABLE.open() as table:
        known = list(csv.reader(table))[1:]
    worst = max(abs(float(k[i]) - row[i]) for k, row in zip(known, rows, strict=True) for i in range(1, 20))
    print(f"{len(rows)} projections, off by at most {worst:g} pixels")
    return 0 if worst < 1e-9 else 1


if __name__ == "__main__":
    sys.exit(main())
