#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the golden files of tests/calibration/formats/format_golden_test.cpp, and expected.csv: pixels of a
few points of the world. Independent of Dewpoint: OpenCV's FileStorage and mrcal write their own
files, the others are put together here from the documented fields; the pixels are those of
cv2.projectPoints, cv2.fisheye.projectPoints and mrcal.project. Needs python3-opencv and
python3-mrcal. Run in this folder."""
import json
import os

import cv2
import mrcal
import numpy as np

SIZE = (1280, 720)
POINTS = np.array([[0.0, 0.0, 0.0], [0.4, -0.3, 0.2], [-0.5, 0.45, 0.9], [0.1, 0.6, 0.5]])


def look_at(position, roll):
    """Camera from world; the camera looks at (0, 0, 0.4), z up."""
    position = np.array(position, float)
    z = np.array([0, 0, 0.4]) - position
    z /= np.linalg.norm(z)
    x = np.cross(z, [0, 0, 1.0])
    x /= np.linalg.norm(x)
    r = np.array([x, np.cross(z, x), z])
    r = cv2.Rodrigues(np.array([0, 0, roll]))[0] @ r
    return r, -r @ position


class Camera:
    def __init__(self, name, position, roll, matrix, distortion, fisheye=False):
        self.name = name
        self.r, self.t = look_at(position, roll)
        fx, fy, cx, cy = matrix
        self.k = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1.0]])
        self.d = np.array(distortion, float)
        self.fisheye = fisheye

    def pixels(self, points):
        rvec = cv2.Rodrigues(self.r)[0]
        function = cv2.fisheye.projectPoints if self.fisheye else cv2.projectPoints
        points = np.ascontiguousarray(points.reshape(-1, 1, 3))
        return function(points, rvec, self.t.reshape(3, 1), self.k, self.d)[0].reshape(-1, 2)

    def four(self):
        other = Camera.__new__(Camera)
        other.__dict__ = dict(self.__dict__, d=self.d[:4])
        return other


LEFT = Camera("left", (2.0, -1.5, 1.4), 0.05, (903.5, 907.9, 618.3, 394.2),
              (-0.3321, 0.1642, -0.0042957, 0.0041132, -0.0415))
RIGHT = Camera("right", (1.9, 1.7, 1.2), -0.1, (870.3, 868.1, 640.1, 352.2),
               (0.0986, -0.2197, 0.000411, -0.0026, 0.0807))
TOP = Camera("top", (-2.2, 0.3, 2.1), 1.5, (650.8, 654.5, 647.3, 362.2),
             (-0.1804, 0.0560, 0.00321, 0.00224, -0.0124))
RIG = [LEFT, RIGHT, TOP]
FOUR = [camera.four() for camera in RIG]
ROUND = [Camera("left", (2.0, -1.5, 1.4), 0.05, (420.5, 421.9, 638.3, 364.2),
                (0.0213, -0.0121, 0.0034, -0.0011), True),
         Camera("right", (1.9, 1.7, 1.2), -0.1, (415.3, 414.1, 640.1, 352.2),
                (0.0186, -0.0097, 0.0041, -0.0016), True)]
EXPECTED = []


def expect(file, cameras, names=None, world=None):
    """`world`: the file's world from ours, (R, t)."""
    points = POINTS if world is None else POINTS @ world[0].T + world[1]
    for i, camera in enumerate(cameras):
        for point, pixel in zip(points, camera.pixels(POINTS)):
            EXPECTED.append([file, names[i] if names else camera.name, *point, *pixel])


def row(values):
    return "[ " + ", ".join(repr(float(v)) for v in np.asarray(values).ravel()) + ",]"


def rows(matrix):
    return "[ " + ", ".join(row(r) for r in matrix) + ",]"


def rvec(camera):
    return cv2.Rodrigues(camera.r)[0].ravel()


def toml_camera(section, camera, scale, size, extra=""):
    return (f'[{section}]\nname = "{camera.name}"\nsize = {size}\nmatrix = {rows(camera.k)}\n'
            f"distortions = {row(camera.d)}\nrotation = {row(rvec(camera))}\n"
            f"translation = {row(camera.t * scale)}\n{extra}\n")


def anipose():
    text = "".join(toml_camera(f"cam_{i}", c, 1000, "[ 1280, 720,]") for i, c in enumerate(RIG))
    open("anipose_mm.toml", "w").write(text + "[metadata]\nadjusted = true\nerror = 0.61\n")
    expect("anipose_mm.toml", RIG)
    text = "".join(toml_camera(f"cam_{i}", c, 1000, "[ 1280, 720,]", "fisheye = true\n")
                   for i, c in enumerate(ROUND))
    open("anipose_fisheye_mm.toml", "w").write(text + "[metadata]\nadjusted = false\nerror = 0.4\n")
    expect("anipose_fisheye_mm.toml", ROUND)


def pose2sim():
    text = "".join(toml_camera(c.name, c, 1, "[ 1280.0, 720.0]", "fisheye = false\n") for c in FOUR)
    open("pose2sim.toml", "w").write(text + "[metadata]\nadjusted = false\nerror = 0.0\n")
    expect("pose2sim.toml", FOUR)


def caliscope():
    text = ""
    for i, c in enumerate(RIG):
        text += (f"[cameras.{i}]\ncam_id = {i}\nrotation_count = 0\nerror = 0.4\nexposure = -6\n"
                 f"grid_count = 33\nignore = false\nsize = [1280, 720]\nmatrix = {rows(c.k)}\n"
                 f"distortions = {row(c.d)}\nverified_resolutions = [[1280, 720]]\n"
                 f"translation = {row(c.t)}\nrotation = {rows(c.r)}\nfisheye = false\n\n")
    open("camera_array.toml", "w").write(text)
    expect("camera_array.toml", RIG, ["cam_0", "cam_1", "cam_2"])


def relative(camera, before):
    """camera from before: R, t."""
    r = camera.r @ before.r.T
    return r, camera.t - r @ before.t


def opencv():
    r, t = relative(RIGHT, LEFT)
    storage = cv2.FileStorage("intrinsics.yml", cv2.FILE_STORAGE_WRITE)
    for i, c in enumerate([LEFT, RIGHT]):
        storage.write(f"M{i + 1}", c.k)
        storage.write(f"D{i + 1}", c.d.reshape(1, -1))
    storage.release()
    storage = cv2.FileStorage("extrinsics.yml", cv2.FILE_STORAGE_WRITE)
    storage.write("R", r)
    storage.write("T", t.reshape(3, 1) / 0.025)  # squares of 25 mm
    storage.write("Q", np.eye(4))
    storage.release()
    expect("intrinsics.yml", [LEFT, RIGHT], ["camera 1", "camera 2"], (LEFT.r, LEFT.t))
    expect("extrinsics.yml", [LEFT, RIGHT], ["camera 1", "camera 2"], (LEFT.r, LEFT.t))
    storage = cv2.FileStorage("opencv_sample.yml", cv2.FILE_STORAGE_WRITE)
    storage.write("image_width", 1280)
    storage.write("image_height", 720)
    storage.write("camera_matrix", TOP.k)
    storage.write("distortion_coefficients", TOP.d.reshape(-1, 1))
    storage.write("avg_reprojection_error", 0.31)
    storage.write("extrinsic_parameters", np.hstack([rvec(TOP), TOP.t * 100]).reshape(1, 6))
    storage.release()
    expect("opencv_sample.yml", [TOP], ["opencv_sample"])


def quaternion(r):
    """x y z w."""
    angle = np.linalg.norm(cv2.Rodrigues(r)[0])
    axis = cv2.Rodrigues(r)[0].ravel() / angle
    return [*(axis * np.sin(angle / 2)), np.cos(angle / 2)]


def ros():
    def matrix(key, values):
        values = np.atleast_2d(values)
        return (f"{key}:\n  rows: {values.shape[0]}\n  cols: {values.shape[1]}\n  data: ["
                + ", ".join(repr(float(v)) for v in values.ravel()) + "]\n")
    os.makedirs("ros", exist_ok=True)
    transforms = ""
    for c, model in ((LEFT, "plumb_bob"), (ROUND[1], "equidistant")):
        open(f"ros/{c.name}.yaml", "w").write(
            f"image_width: 1280\nimage_height: 720\ncamera_name: {c.name}\n"
            + matrix("camera_matrix", c.k) + f"distortion_model: {model}\n"
            + matrix("distortion_coefficients", c.d) + matrix("rectification_matrix", np.eye(3))
            + matrix("projection_matrix", np.hstack([c.k, np.zeros((3, 1))])))
        x, y, z = -c.r.T @ c.t
        a, b, d, w = quaternion(c.r.T)
        transforms += (f"- header:\n    frame_id: world\n  child_frame_id: {c.name}_optical_frame\n"
                       f"  transform:\n    translation:\n      x: {x}\n      y: {y}\n      z: {z}\n"
                       f"    rotation:\n      x: {a}\n      y: {b}\n      z: {d}\n      w: {w}\n")
    open("ros/static_transforms.yaml", "w").write(transforms)
    expect("ros", [LEFT, ROUND[1]])


def kalibr():
    for file, cameras, model in (("camchain.yaml", FOUR, "radtan"),
                                 ("camchain_equi.yaml", ROUND, "equidistant")):
        text = ""
        for i, c in enumerate(cameras):
            text += f"cam{i}:\n"
            if i > 0:
                r, t = relative(c, cameras[i - 1])
                step = np.vstack([np.hstack([r, t.reshape(3, 1)]), [0, 0, 0, 1]])
                text += "  T_cn_cnm1:\n" + "".join(
                    "  - [" + ", ".join(repr(float(v)) for v in line) + "]\n" for line in step)
            text += (f"  cam_overlaps: {[j for j in range(len(cameras)) if j != i]}\n"
                     f"  camera_model: pinhole\n  distortion_coeffs: {c.d.tolist()}\n"
                     f"  distortion_model: {model}\n  intrinsics: "
                     f"{[c.k[0, 0], c.k[1, 1], c.k[0, 2], c.k[1, 2]]}\n  resolution: [1280, 720]\n"
                     f"  rostopic: /cam{i}/image_raw\n  timeshift_cam_imu: 0.0012\n")
        open(file, "w").write(text)
        first = cameras[0]
        expect(file, cameras, [f"cam{i}" for i in range(len(cameras))], (first.r, first.t))


def with_mrcal():
    os.makedirs("mrcal", exist_ok=True)
    for c in (LEFT, RIGHT):
        intrinsics = np.hstack([c.k[0, 0], c.k[1, 1], c.k[0, 2], c.k[1, 2], c.d])
        model = mrcal.cameramodel(intrinsics=("LENSMODEL_OPENCV5", intrinsics),
                                  imagersize=np.array(SIZE),
                                  extrinsics_rt_fromref=np.hstack([rvec(c), c.t]))
        model.write(f"mrcal/{c.name}.cameramodel")
        model = mrcal.cameramodel(f"mrcal/{c.name}.cameramodel")  # it writes ten digits
        inside = mrcal.transform_point_rt(model.extrinsics_rt_fromref(), POINTS)
        for point, pixel in zip(POINTS, mrcal.project(inside, *model.intrinsics())):
            EXPECTED.append(["mrcal", c.name, *point, *pixel])


def mc_calib():
    storage = cv2.FileStorage("mc_calib.yml", cv2.FILE_STORAGE_WRITE)
    storage.write("nb_camera", 3)
    for i, c in enumerate(RIG):
        r, t = relative(c, LEFT)
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = r.T, -r.T @ t * 100  # rig from camera, cm
        storage.startWriteStruct(f"camera_{i}", cv2.FileNode_MAP)
        storage.write("camera_matrix", c.k)
        storage.write("distortion_vector", c.d.reshape(1, -1))
        storage.write("distortion_type", 0)
        storage.write("camera_group", 0)
        storage.write("img_width", 1280)
        storage.write("img_height", 720)
        storage.write("camera_pose_matrix", pose)
        storage.endWriteStruct()
    storage.release()
    expect("mc_calib.yml", RIG, ["camera_0", "camera_1", "camera_2"], (LEFT.r, LEFT.t))


def qualisys():
    """QTM: position and axes of the camera in mm, axes x right, y up, z backward as the columns of
    its rotation, which the file lists column by column; 64 units per pixel from the corner of the
    whole sensor, of which the video is a part."""
    left, top = 16, 8
    text = ('<?xml version="1.0" encoding="UTF-8"?>\n<calibration calibrated="2026.01.01" source="x.qtm" '
            'type="regular">\n<cameras>\n<camera active="1" avg-residual="0.4" serial="999" '
            'model="Oqus 7+" viewrotation="0"/>\n')
    for c, serial in zip(RIG, ("26578", "26579", "26585")):
        x, y, z = -c.r.T @ c.t * 1000
        axes = np.array([c.r[0], -c.r[1], -c.r[2]]).T  # world from camera
        r = " ".join(f'r{i + 1}{j + 1}="{axes[j, i]!r}"' for i in range(3) for j in range(3))
        text += (f'<camera active="1" avg-residual="0.5" serial="{serial}" model="Miqus Video" '
                 f'viewrotation="0">\n<fov_video left="{left}" top="{top}" right="{left + 1279}" '
                 f'bottom="{top + 719}"/>\n<transform x="{x!r}" y="{y!r}" z="{z!r}" {r}/>\n'
                 f'<intrinsic focallength="9.2" sensorMinU="0.0" sensorMaxU="83967.0" '
                 f'sensorMinV="0.0" sensorMaxV="48127.0" focalLengthU="{c.k[0, 0] * 64!r}" '
                 f'focalLengthV="{c.k[1, 1] * 64!r}" centerPointU="{(c.k[0, 2] + left) * 64!r}" '
                 f'centerPointV="{(c.k[1, 2] + top) * 64!r}" skew="0" '
                 f'radialDistortion1="{c.d[0]}" radialDistortion2="{c.d[1]}" '
                 f'radialDistortion3="{c.d[4]}" tangentalDistortion1="{c.d[2]}" '
                 f'tangentalDistortion2="{c.d[3]}"/>\n</camera>\n')
    open("session.qca.txt", "w").write(text + "</cameras>\n</calibration>\n")
    expect("session.qca.txt", RIG, ["26578", "26579", "26585"])


def multical():
    data = {"cameras": {}, "camera_poses": {}}
    for i, c in enumerate(RIG):
        data["cameras"][c.name] = {"model": "standard", "image_size": list(SIZE),
                                   "K": c.k.tolist(), "dist": [c.d.tolist()]}
        r, t = relative(c, LEFT)
        key = c.name if i == 0 else f"{c.name}_to_left"
        data["camera_poses"][key] = {"R": r.tolist(), "T": t.tolist()}
    data["image_sets"] = {"rgb": []}
    json.dump(data, open("multical.json", "w"), indent=1)
    expect("multical.json", RIG, None, (LEFT.r, LEFT.t))


for make in (anipose, pose2sim, caliscope, opencv, ros, kalibr, with_mrcal, mc_calib, qualisys,
             multical):
    make()
with open("expected.csv", "w") as out:
    out.write("# file, camera, point of the file's world in meters, pixel\n")
    for line in EXPECTED:
        out.write(",".join(v if isinstance(v, str) else repr(float(v)) for v in line) + "\n")
