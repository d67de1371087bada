#!/usr/bin/python3
"""`import specbake`, beside oracles: numpy's own sums over the tables of data/ (tests/foreign/color.py),
files as a few lines of struct read them (tests/foreign/exr.py) and as OpenImageIO's Python does.

    module_test.py PACKAGE_FOLDER PROGRAM [unittest's arguments]
"""

import ast
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PACKAGE, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]
sys.path[:0] = [str(PACKAGE), str(ROOT / "tests/foreign")]

import numpy as np

import color
import exr
import specbake

IMAGES = ROOT / "testimages"
REC709 = color.rgb_to_xyz(color.weights("D65").sum(axis=0))

# A blend is a sum of four products in float: 5 roundings of numbers that are at most 1, and a node's
# own; the sum over the bands weighs them by at most white's Z, 1.09.
SUM_TOLERANCE = 1.1 * 6 * 2.0**-24


def random_colors(count, seed=1):
    return np.random.default_rng(seed).random((count, 3), dtype=np.float32)


def random_reflectances(count):
    """Sums of a few Gaussians, squeezed into (0, 1): colours that a surface can have."""
    rng = np.random.default_rng(2)
    nm = specbake.WAVELENGTHS
    total = rng.normal(0, 2, (count, 1))
    for _ in range(4):
        center, width, height = (rng.uniform(*r, (count, 1)) for r in
                                 ((380, 780), (20, 150), (-6, 6)))
        total = total + height * np.exp(-(((nm - center) / width) ** 2))
    return 1 / (1 + np.exp(-total))


class Spectra(unittest.TestCase):
    model = specbake.Upsampler("lin_rec709")

    def test_colors_are_exact_by_numpys_own_sum(self):
        colors = random_colors(100_000)
        spectra = self.model.spectra(colors)
        self.assertEqual((spectra.shape, spectra.dtype), ((100_000, 81), np.float32))
        self.assertTrue(((spectra >= 0) & (spectra <= 1)).all())
        got = spectra.astype(np.float64) @ color.weights("D65")
        wanted = colors.astype(np.float64) @ REC709.T
        self.assertLess(np.abs(got - wanted).max(), SUM_TOLERANCE)
        self.assertLess(np.abs(self.model.xyz(colors) - wanted).max(), 1e-12)

    def test_every_light_and_colors_of_real_surfaces(self):
        reflectances = random_reflectances(300)
        for light in specbake.LIGHTS:
            weights = color.weights(light)
            np.testing.assert_allclose(specbake.Observer(light).weights, weights, atol=1e-15)
            asked = (reflectances @ weights).astype(np.float32)
            got = specbake.Upsampler("xyz", light=light).spectra(asked) @ weights
            # Z of white is up to 1.2 under these lights (D75).
            self.assertLess(np.abs(got - asked).max(), 1.2 * SUM_TOLERANCE, light)

    def test_types_mean_what_a_texture_means_by_them(self):
        srgb = specbake.Upsampler("srgb")
        stored = np.random.default_rng(3).integers(0, 256, (50, 3), dtype=np.uint8)
        wanted = self.model.spectra(color.linear_from_srgb(stored / 255))
        # Decoded by another pow: an ulp of the colour, times the steepest slope, below 10.
        atol = 10 * 2.0**-23
        np.testing.assert_allclose(srgb.spectra(stored), wanted, atol=atol)
        np.testing.assert_allclose(srgb.spectra(stored.astype(np.uint16) * 257), wanted, atol=atol)
        np.testing.assert_allclose(srgb.spectra(stored / 255), wanted, atol=3 * atol)
        halves = (stored / 255).astype(np.float16)
        np.testing.assert_array_equal(self.model.spectra(halves),
                                      self.model.spectra(halves.astype(np.float32)))
        np.testing.assert_array_equal(self.model.spectra([1, 0, 0]),
                                      self.model.spectra(np.float32([1, 0, 0])))

    def test_any_layout(self):
        image = random_colors(6 * 8).reshape(6, 8, 3)
        wanted = self.model.spectra(image)
        self.assertEqual(wanted.shape, (6, 8, 81))
        np.testing.assert_array_equal(self.model.spectra(image[::-1, ::2]), wanted[::-1, ::2])
        np.testing.assert_array_equal(self.model.spectra(np.asfortranarray(image)), wanted)
        np.testing.assert_array_equal(self.model.spectra(image.astype(">f4")), wanted)
        np.testing.assert_array_equal(self.model.spectra(image[2, 3]), wanted[2, 3])
        unaligned = np.frombuffer(b"x" + image.tobytes(), np.uint8)[1:].view(np.float32)
        np.testing.assert_array_equal(self.model.spectra(unaligned.reshape(6, 8, 3)), wanted)
        self.assertEqual(self.model.spectra(np.empty((0, 3))).shape, (0, 81))

    def test_halves_and_wavelengths(self):
        colors = random_colors(100)
        bands = self.model.spectra(colors)
        np.testing.assert_array_equal(self.model.spectra(colors, dtype=np.float16),
                                      bands.astype(np.float16))
        nm = [300, 380, 381.25, 550, 777.5, 780, 830]
        wanted = [np.interp(nm, specbake.WAVELENGTHS, s) for s in bands.astype(np.float64)]
        np.testing.assert_allclose(self.model.spectra(colors, wavelengths=nm), wanted,
                                   atol=8 * 2.0**-24)

    def test_out_is_what_is_returned(self):
        colors = random_colors(10)
        out = np.empty((10, 81), np.float32)
        self.assertIs(self.model.spectra(colors, out=out), out)
        np.testing.assert_array_equal(out, self.model.spectra(colors))
        readonly = out.copy()
        readonly.flags.writeable = False
        for wrong in [out[:9], out.astype(np.float64), out.T, readonly, "no"]:
            with self.assertRaises(specbake.ArgumentError):
                self.model.spectra(colors, out=wrong)

    def test_threads_do_not_show(self):
        colors = random_colors(50_000) * 1.2 - 0.1  # some are outside the cube
        colors[100:] = random_colors(49_900)
        wanted = self.model.spectra(colors, threads=1)
        for threads in (2, 3, 0):
            fresh = specbake.Upsampler("lin_rec709")
            np.testing.assert_array_equal(fresh.spectra(colors, threads=threads), wanted)

    def test_python_goes_on_meanwhile(self):
        turns, over = [0], threading.Event()

        def turn():
            while not over.is_set():
                turns[0] += 1

        other = threading.Thread(target=turn)
        other.start()
        before = turns[0]
        self.model.spectra(random_colors(300_000))
        after = turns[0]
        over.set()
        other.join()
        self.assertGreater(after, before + 1000)

    def test_colors_without_a_spectrum(self):
        colors = random_colors(9000).reshape(90, 100, 3)
        wanted = self.model.spectra(colors)
        colors[41, 7, 1] = np.nan
        colors[80, 3] = np.inf
        with self.assertRaisesRegex(specbake.ArgumentError, r"\(41, 7\).*finite.*2 such"):
            self.model.spectra(colors)
        wanted[41, 7] = wanted[80, 3] = np.nan
        np.testing.assert_array_equal(self.model.spectra(colors, invalid="nan"), wanted)
        strict = specbake.Upsampler("lin_rec709", outside="error")
        with self.assertRaisesRegex(specbake.ArgumentError, "the colour is one that no refl"):
            strict.spectra([2, 0, 0])
        moved = self.model.spectra([2, 0, 0])
        self.assertTrue(((moved >= 0) & (moved <= 1)).all())

    def test_solve(self):
        solution = self.model.solve([0.8, 0.3, 0.1])
        self.assertEqual(solution.status, "solved")
        got = solution.reflectance @ color.weights("D65")
        self.assertLess(np.abs(got - REC709 @ [0.8, 0.3, 0.1]).max(), 1e-11)
        np.testing.assert_allclose(solution.given, solution.asked, atol=0)
        same = self.model.solve(xyz=solution.asked)
        np.testing.assert_array_equal(same.reflectance, solution.reflectance)
        outside = self.model.solve(xyz=[0, 2, 0])
        self.assertTrue(outside.outside and outside.gauge > 1 and outside.delta_e > 1)
        encoded = specbake.Upsampler("srgb").solve([0.5, 0.5, 0.5])
        self.assertAlmostEqual(encoded.asked[1], float(color.linear_from_srgb(0.5)), 12)
        for wrong in [dict(), dict(color=[1, 2]), dict(color=[np.nan, 0, 0]),
                      dict(color=[0, 0, 0], xyz=[0, 0, 0])]:
            with self.assertRaises(specbake.ArgumentError):
                self.model.solve(**wrong)

    def test_samples_and_materials(self):
        chart = ROOT / "data/colorchecker_24.csv"
        rows = [line.split(",") for line in chart.read_text().splitlines()
                if line and not line.startswith("#")][1:]
        measured = np.array([[float(v) for v in row[1:]] for row in rows])
        model = specbake.Upsampler("xyz", light="D65", grid=None, samples=chart)
        for reflectance in measured[:6]:
            got = model.solve(xyz=reflectance @ color.weights("D65")).reflectance
            np.testing.assert_allclose(got, reflectance, atol=1e-6)
        skin = specbake.Upsampler("srgb", material="skin")
        tone = np.array([200, 150, 125], np.uint8)
        self.assertGreater(np.abs(skin.spectra(tone) -
                                  specbake.Upsampler("srgb").spectra(tone)).max(), 0.005)
        self.assertIn("skin", specbake.MATERIALS)
        for wrong, error in [(dict(material="cheese"), specbake.ArgumentError),
                             (dict(samples="absent.csv"), specbake.FileError)]:
            with self.assertRaises(error):
                specbake.Upsampler(**wrong)

    def test_the_observer_of_10_degrees_by_its_name_and_by_its_table(self):
        table = np.genfromtxt(ROOT / "data/cie1964_10deg_1nm.csv", delimiter=",", skip_header=3)
        bands = table[np.isin(table[:, 0], specbake.WAVELENGTHS)][:, 1:]
        self.assertEqual(bands.shape, (81, 3))
        for observer in ("10", str(ROOT / "data/cie1964_10deg_1nm.csv")):
            eye = specbake.Observer("E", observer=observer)
            self.assertEqual(eye.name, "CIE 1964 10 degree, 5 nm")
            np.testing.assert_allclose(eye.weights, bands / bands[:, 1].sum(), rtol=1e-14)
            model = specbake.Upsampler("xyz", grid=None, observer=observer)
            spectrum = model.spectra([[0.3, 0.25, 0.2]])[0]
            np.testing.assert_allclose(spectrum @ eye.weights, [0.3, 0.25, 0.2], atol=1e-6)
        with self.assertRaises(specbake.ArgumentError):
            specbake.Observer("E", observer="3")

    def test_the_fine_quadrature_and_other_wavelengths(self):
        colors = random_colors(20_000)
        nm_of = {"380:780:5": np.arange(380, 781, 5), "400:700:10": np.arange(400, 701, 10),
                 "360:830:2.5": np.linspace(360, 830, 189)}
        for text, nm in nm_of.items():
            weights = color.fine_weights("D65", nm)
            white = weights.sum(axis=0)
            wanted = colors.astype(np.float64) @ color.rgb_to_xyz(white).T
            for asked in (text, nm, list(nm)):
                model = specbake.Upsampler("lin_rec709", wavelengths=asked)
                self.assertEqual(model.quadrature, "fine")
                np.testing.assert_allclose(model.wavelengths, nm, rtol=0, atol=1e-9)
                spectra = model.spectra(colors)
                self.assertEqual(spectra.shape, (20_000, len(nm)))
                # Between knots a value is one more sum of two products.
                self.assertLess(np.abs(spectra @ weights - wanted).max(), 1.5 * SUM_TOLERANCE, text)
            # Rounded to multiples of 2^-40, each of N weights.
            np.testing.assert_allclose(model.observer.weights, weights, atol=2.0**-41 + 1e-14)
            np.testing.assert_allclose(
                specbake.Observer("D65", wavelengths=nm).white, white, atol=len(nm) * 2.0**-41)
            solution = model.solve([0.8, 0.3, 0.1])
            self.assertEqual(solution.reflectance.shape, nm.shape)
            self.assertLess(np.abs(solution.reflectance @ weights -
                                   color.rgb_to_xyz(white) @ [0.8, 0.3, 0.1]).max(), 2e-10)
        for light in specbake.LIGHTS:
            weights = color.fine_weights(light, specbake.WAVELENGTHS)
            observer = specbake.Observer(light, quadrature="fine")
            np.testing.assert_allclose(observer.weights, weights, atol=2.0**-41 + 1e-14)
        usual = specbake.Upsampler("lin_rec709", wavelengths="380:780:5", quadrature="fine")
        nm = [390, 412.5, 800]
        wanted = [np.interp(nm, usual.wavelengths, s) for s in usual.spectra(colors[:50])]
        np.testing.assert_allclose(usual.spectra(colors[:50], wavelengths=nm), wanted,
                                   atol=8 * 2.0**-24)

    def test_adaptation(self):
        light = specbake.Observer("A")
        for adapt in ("bradford", "none"):
            model = specbake.Upsampler("lin_rec709", light="A", adapt=adapt)
            wanted = color.rgb_to_xyz(light.white)
            if adapt == "bradford":
                white = color.weights("D65").sum(axis=0)
                wanted = color.bradford(white, light.white).T @ REC709
            np.testing.assert_allclose(model.xyz(np.eye(3, dtype=np.float32)), wanted.T, atol=1e-9)

    def test_wrong_arguments(self):
        for wrong in [dict(space="nowhere"), dict(light="sun"), dict(method="guess"),
                      dict(outside="far"), dict(grid=1), dict(grid=1000), dict(adapt="eye"),
                      dict(quadrature="coarse"), dict(wavelengths="400:700"),
                      dict(wavelengths=[400, 410, 430, 440]), dict(wavelengths=[500]),
                      dict(wavelengths=[]), dict(wavelengths=[400, np.nan, 500, 600]),
                      dict(wavelengths="400:700:10", quadrature="bands")]:
            with self.assertRaises(specbake.ArgumentError) as raised:
                specbake.Upsampler(**wrong)
            self.assertIsInstance(raised.exception, (ValueError, specbake.Error))
        for colors in [1.0, [1, 2], np.zeros((3, 2)), np.zeros((2, 3), complex), ["a", "b", "c"]]:
            with self.assertRaises(specbake.ArgumentError):
                self.model.spectra(colors)
        for wrong in [dict(dtype="float64"), dict(invalid="?"), dict(threads=-1),
                      dict(wavelengths=[np.nan])]:
            with self.assertRaises(specbake.ArgumentError):
                self.model.spectra([0, 0, 0], **wrong)


CONFIG = """ocio_profile_version: 2
roles: {default: Raw, scene_linear: Linear}
displays:
  screen:
    - !<View> {name: Raw, colorspace: Raw}
colorspaces:
  - !<ColorSpace> {name: Raw, isdata: true}
  - !<ColorSpace> {name: Linear, aliases: [acescg]}
  - !<ColorSpace>
    name: Squared
    to_scene_reference: !<ExponentTransform> {value: 2}
"""


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return pathlib.Path(self.folder.name) / name

    def program(self, *arguments):
        subprocess.run([PROGRAM, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    def test_bake_writes_what_the_program_writes(self):
        options = dict(tile=(32, 16), mipmap=True, dtype="float32", light="D50", space="srgb")
        statistics = specbake.bake(IMAGES / "rgba8.png", self.path("module.exr"), **options)
        self.assertEqual((statistics.light, statistics.space), ("D50", "srgb"))
        self.program("bake", "-q", IMAGES / "rgba8.png", "-o", self.path("program.exr"), "--tile",
                     "32", "16", "--mipmap", "-d", "float", "--illuminant", "D50", "--space", "srgb")
        self.assertEqual(self.path("module.exr").read_bytes(),
                         self.path("program.exr").read_bytes())

    def test_a_bake_of_other_wavelengths_is_verified_and_relit_by_numpy(self):
        nm = np.arange(400, 701, 10)
        specbake.bake(IMAGES / "rgb8.png", self.path("a.exr"), wavelengths=nm, dtype="float32",
                      compression="none")
        self.program("bake", "-q", IMAGES / "rgb8.png", "-o", self.path("b.exr"), "-d", "float",
                     "--wavelengths", "400:700:10", "--compression", "none")
        self.assertEqual(self.path("a.exr").read_bytes(), self.path("b.exr").read_bytes())
        samples, _ = exr.read(self.path("a.exr"))
        spectra = np.stack([samples[f"T.{n},000000nm"] for n in nm], axis=-1)
        image = specbake.read_spectral(self.path("a.exr"))
        np.testing.assert_array_equal(image.spectra, spectra)
        np.testing.assert_array_equal(image.wavelengths, nm)
        right = specbake.verify(self.path("a.exr"), IMAGES / "rgb8.png")
        self.assertTrue(right.passes())
        self.assertEqual(right.quadrature, "fine")
        specbake.relight(self.path("a.exr"), self.path("lit.exr"), light="F11", adapt=False)
        import OpenImageIO
        got = OpenImageIO.ImageBuf(str(self.path("lit.exr"))).get_pixels(OpenImageIO.FLOAT)[..., :3]
        weights = color.fine_weights("F11", nm)
        daylight = color.fine_weights("D65", nm).sum(axis=0)
        rgb = np.linalg.inv(color.rgb_to_xyz(daylight))
        wanted = spectra @ weights @ rgb.T / (rgb @ weights.sum(axis=0)).max()
        np.testing.assert_allclose(got, wanted, rtol=2.0**-11, atol=1e-5)

    def test_an_image_in_an_array_is_baked_as_the_model_says(self):
        rng = np.random.default_rng(4)
        model = specbake.Upsampler("srgb")
        wide = rng.integers(0, 256, (7, 20, 4), dtype=np.uint8)
        for image in [wide, wide[:, 3:15], wide[::-1], wide[::2, ::2], wide.astype(">u2")]:
            specbake.bake(image, self.path("a.exr"), dtype="float32", compression="none")
            samples, _ = exr.read(self.path("a.exr"))
            wanted = model.spectra(np.ascontiguousarray(image[..., :3]))
            for band, nm in enumerate(specbake.WAVELENGTHS):
                np.testing.assert_array_equal(samples[f"T.{nm:.0f},000000nm"], wanted[..., band])
            full = 255 if image.dtype == np.uint8 else 65535
            np.testing.assert_array_equal(samples["A"], (image[..., 3] / np.float32(full)))
        for wrong in [wide.astype(np.float64), np.zeros((4, 4, 5), np.uint8),
                      np.zeros((0, 4, 3), np.uint8)]:
            with self.assertRaises(specbake.ArgumentError):
                specbake.bake(wrong, self.path("b.exr"))
        with self.assertRaises(TypeError):
            specbake.bake(17, self.path("b.exr"))
        with self.assertRaises(specbake.ArgumentError):
            specbake.bake(wide, self.path("b.exr"), orient=True)
        self.assertFalse(self.path("b.exr").exists())

    def test_a_configuration_of_opencolorio(self):
        """What its spaces mean is compared in tests/foreign/configured.py."""
        config = self.path("studio.ocio")
        config.write_text(CONFIG)
        words = dict(space="Squared", colorconfig=config, dtype="float32", compression="none")
        try:
            specbake.bake(IMAGES / "rgb8.png", self.path("module.exr"), **words)
        except specbake.FileError as error:
            self.assertIn("built without", str(error))
            self.skipTest("built without OpenColorIO")
        self.program("bake", "-q", IMAGES / "rgb8.png", "-o", self.path("program.exr"), "-d", "float",
                     "--compression", "none", "--colorconfig", config, "--space", "Squared")
        self.assertEqual(self.path("module.exr").read_bytes(),
                         self.path("program.exr").read_bytes())
        import OpenImageIO
        image = OpenImageIO.ImageBuf(str(IMAGES / "rgb8.png")).get_pixels(OpenImageIO.UINT8)
        specbake.bake(image, self.path("array.exr"), **words)
        array, file = (exr.read(self.path(n))[0] for n in ("array.exr", "module.exr"))
        for band in file:
            np.testing.assert_array_equal(array[band], file[band])
        verified = specbake.verify(self.path("module.exr"), IMAGES / "rgb8.png", colorconfig=config)
        self.assertTrue(verified.passes())

    def test_read_spectral_reads_what_others_read(self):
        specbake.bake(IMAGES / "rgba8.png", self.path("a.exr"), compression="none")
        image = specbake.read_spectral(self.path("a.exr"))
        oracle, _ = exr.read(self.path("a.exr"))
        bands = np.stack([oracle[f"T.{nm:.0f},000000nm"] for nm in specbake.WAVELENGTHS], axis=-1)
        np.testing.assert_array_equal(image.spectra, bands.astype(np.float32))
        np.testing.assert_array_equal(image.alpha, oracle["A"].astype(np.float32))
        np.testing.assert_array_equal(image.preview, np.stack(
            [oracle[c] for c in "RGB"], axis=-1).astype(np.float32))
        self.assertEqual((image.light, image.stored_dtype), ("D65", "float16"))
        rows = specbake.read_spectral(self.path("a.exr"), rows=(3, 9))
        np.testing.assert_array_equal(rows.spectra, image.spectra[3:9])
        self.assertEqual(rows.data_window[1], image.data_window[1] + 3)
        for wrong in [(-1, 2), (2, 2), (0, 10**6)]:
            with self.assertRaises(specbake.ArgumentError):
                specbake.read_spectral(self.path("a.exr"), rows=wrong)

    def test_openimageio_reads_the_same(self):
        try:
            import OpenImageIO
        except ImportError:
            self.skipTest("no python3-openimageio")
        specbake.bake(IMAGES / "rgb16.png", self.path("a.exr"), compression="zip")
        image = specbake.read_spectral(self.path("a.exr"))
        pixels = OpenImageIO.ImageBuf(str(self.path("a.exr"))).get_pixels(OpenImageIO.FLOAT)
        names = OpenImageIO.ImageBuf(str(self.path("a.exr"))).spec().channelnames
        first = names.index("T.380,000000nm")
        np.testing.assert_array_equal(image.spectra, pixels[..., first:first + 81])

    def test_relight_is_numpys_sum(self):
        colors = random_colors(24).reshape(4, 6, 3)
        specbake.bake(colors, self.path("a.exr"), dtype="float32")
        specbake.relight(self.path("a.exr"), self.path("b.exr"), light="F11", adapt=False,
                         exposure=-1)
        weights = color.weights("F11")
        rgb = np.linalg.inv(REC709)
        white = (rgb @ weights.sum(axis=0)).max()
        spectra = specbake.read_spectral(self.path("a.exr")).spectra.astype(np.float64)
        wanted = spectra @ weights @ rgb.T / white / 2
        import OpenImageIO
        got = OpenImageIO.ImageBuf(str(self.path("b.exr"))).get_pixels(OpenImageIO.FLOAT)[..., :3]
        # A half's 11 bits, where the picture is stored so.
        np.testing.assert_allclose(got, wanted, rtol=2.0**-11, atol=1e-5)

    def test_verify(self):
        specbake.bake(IMAGES / "rgb8.png", self.path("a.exr"))
        right = specbake.verify(self.path("a.exr"), IMAGES / "rgb8.png")
        self.assertTrue(right.passes() and right.max < 0.1 and right.texels > 0)
        wrong = specbake.verify(self.path("a.exr"), IMAGES / "rgb8.png", light="A")
        self.assertFalse(wrong.passes())

    def test_table(self):
        model = specbake.Upsampler("srgb", grid=9)
        table = model.table()
        table.save(self.path("a.spectab"))
        self.program("table", "-o", self.path("b.spectab"), "--grid", "9")
        self.assertEqual(self.path("a.spectab").read_bytes(), self.path("b.spectab").read_bytes())
        self.assertEqual(self.path("a.spectab").read_bytes(), bytes(table))
        again = specbake.Table.load(self.path("a.spectab"))
        colors = random_colors(10_000)
        np.testing.assert_array_equal(again.spectra(colors), table.spectra(colors))
        linear = specbake.Upsampler("lin_rec709", grid=9)
        # Samples of 16 bits: half a step each; and the float sums of both.
        np.testing.assert_allclose(table.spectra(colors), linear.spectra(colors),
                                   atol=0.5 * 1.1 / 65535 + 12 * 2.0**-24)
        nm = [400, 555.5, 700]
        wanted = [np.interp(nm, again.wavelengths, s) for s in table.spectra(colors[:100])]
        np.testing.assert_allclose(table.spectra(colors[:100], wavelengths=nm), wanted, atol=1e-6)
        self.assertEqual(table.nodes, 9)
        damaged = bytearray(bytes(table))
        damaged[5000] ^= 1
        for content in [damaged, damaged[:100], b"", b"\x89SPECTAB"]:
            self.path("c.spectab").write_bytes(content)
            with self.assertRaises(specbake.FileError):
                specbake.Table.load(self.path("c.spectab"))

    def test_errors_name_the_file(self):
        for call in [lambda p: specbake.bake(p, self.path("o.exr")),
                     lambda p: specbake.read_spectral(p), lambda p: specbake.Table.load(p),
                     lambda p: specbake.relight(p, self.path("o.png"))]:
            with self.assertRaises(specbake.FileError) as raised:
                call(self.path("absent.exr"))
            self.assertIsInstance(raised.exception, OSError)
            self.assertIsInstance(raised.exception, specbake.Error)
            self.assertEqual(raised.exception.filename, str(self.path("absent.exr")))
            self.assertTrue(raised.exception.strerror)
        with self.assertRaises(specbake.ArgumentError):
            specbake.bake(IMAGES / "rgb8.png", self.path("o.exr"), compression="rar")
        self.assertEqual(list(self.path("").iterdir()), [])

    def test_progress_and_its_failures(self):
        seen = []
        image = np.zeros((8, 8, 3), np.uint8)
        specbake.bake(image, self.path("a.exr"), progress=seen.append)
        self.assertEqual(seen[-1], 1)

        def fail(done):
            raise KeyError("mine")

        with self.assertRaises(KeyError):
            specbake.bake(image, self.path("b.exr"), progress=fail)

    def test_ctrl_c_stops_long_work(self):
        slow = specbake.Upsampler("lin_rec709", grid=None)
        colors = random_colors(200_000)  # minutes, one by one
        # Python's handlers run in the main thread only.
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            slow.spectra(colors)
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            specbake.bake(colors.reshape(400, 500, 3), self.path("a.exr"), grid=None)
        self.assertEqual(list(self.path("").iterdir()), [])


class Package(unittest.TestCase):
    def test_importing_does_not_load_openimageio(self):
        script = ("import sys; sys.path.insert(0, sys.argv[1]); import specbake;"
                  "specbake.Upsampler().spectra([0, 0, 0]);"
                  "print('OpenImageIO' in open('/proc/self/maps').read())")
        told = subprocess.run([sys.executable, "-c", script, str(PACKAGE)], check=True,
                              capture_output=True, text=True).stdout
        self.assertEqual(told, "False\n")

    def test_the_stub_says_what_there_is(self):
        tree = ast.parse((PACKAGE / "specbake/__init__.pyi").read_text())
        told = {}
        for node in tree.body:
            if isinstance(node, ast.AnnAssign):
                told[node.target.id] = None
            elif isinstance(node, ast.FunctionDef):
                told[node.name] = node
            elif isinstance(node, ast.ClassDef):
                told[node.name] = {n.name: n for n in node.body if isinstance(n, ast.FunctionDef)}
        self.assertEqual(set(specbake.__all__) | {"__all__", "__version__"}, set(told))
        for name, what in told.items():
            thing = getattr(specbake, name)
            if isinstance(what, ast.FunctionDef):
                self.check_signature(thing, what)
            elif isinstance(what, dict):
                self.check_class(thing, what)

    def check_class(self, thing, methods):
        own = {n for n in vars(thing) if not n.startswith("_")}
        self.assertEqual(own, {n for n in methods if not n.startswith("_")}, thing)
        for name, node in methods.items():
            member = vars(thing).get(name)
            if any(getattr(d, "id", "") == "property" for d in node.decorator_list):
                self.assertIsInstance(member, property)
            else:
                self.check_signature(getattr(thing, name), node)

    def check_signature(self, function, node):
        first = function.__doc__.splitlines()[0]
        has = re.findall(r"(?:\(|, )(\w+(?=:)|\*(?=,))", first)
        a = node.args
        wanted = [x.arg for x in a.args] + (["*"] if a.kwonlyargs else [])
        wanted += [x.arg for x in a.kwonlyargs]
        self.assertEqual(has, wanted, first)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
