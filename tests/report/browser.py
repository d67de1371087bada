#!/usr/bin/python3
"""Whether the page of --report shows what is in the file: a headless Chromium opens it, a pointer
and keys go over it, and what it says stands beside `specbake inspect`.

    browser.py PROGRAM WORK [--pictures]    --pictures: keep screenshots in WORK
"""
import argparse
import os
import pathlib
import struct
import subprocess
import sys
import zlib

SKIPPED = 77
WIDE, NARROW = 1280, 390
DEMO = pathlib.Path(__file__).resolve().parents[2] / "testimages/demo.png"

try:
    from PIL import Image
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.chrome.service import Service
except ImportError:
    print("python3-selenium or python3-pil is missing")
    sys.exit(1 if os.environ.get("CI") else SKIPPED)


def browser():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def resize(driver, width, scheme):
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 600})
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
        "features": [{"name": "prefers-color-scheme", "value": scheme}]})


def open_page(driver, page):
    driver.get(page.as_uri())
    for _ in range(200):
        if driver.execute_script("return document.body.dataset.ready === 'yes'"):
            return
        driver.implicitly_wait(0.05)
        driver.find_elements(By.ID, "not-there")
    raise AssertionError("the page does not become ready")


def shown_spectra(driver):
    """{(x, y): [reflectance ...]} of the pinned texels, from the table of numbers."""
    driver.execute_script("document.querySelector('details').open = true")
    rows = [[cell.text for cell in row.find_elements(By.CSS_SELECTOR, "th, td")]
            for row in driver.find_elements(By.CSS_SELECTOR, "#numbers tr")]
    places = [tuple(int(part) for part in name.strip("()").split(",")) for name in rows[0][1:]]
    return {place: [float(row[1 + i]) for row in rows[1:]] for i, place in enumerate(places)}


def inspected(program, spectral, place):
    text = subprocess.run([program, "inspect", spectral, "--at", str(place[0]), str(place[1])],
                          check=True, capture_output=True, text=True).stdout
    return [float(line.split(",")[-1]) for line in text.splitlines()[1:]]


def check_spectra(driver, program, spectral):
    """A code of 16 bits is off by half a unit, 0.5/65535 of an interval of length 1, and five
    decimals by half of the last."""
    allowed = 0.5 / 65535 + 0.5e-5 + 1e-9
    shown = shown_spectra(driver)
    for place, spectrum in shown.items():
        asked = inspected(program, spectral, place)
        assert len(spectrum) == len(asked) == 81, (len(spectrum), len(asked))
        worst = max(abs(a - b) for a, b in zip(spectrum, asked))
        assert worst <= allowed, f"texel {place}: off by {worst}"
    return shown


def check_no_complaints(driver):
    complaints = [entry["message"] for entry in driver.get_log("browser")
                  if entry["level"] == "SEVERE"]
    assert not complaints, complaints


def check_no_network(driver):
    for entry in driver.get_log("performance"):
        assert '"url":"http' not in entry["message"], entry["message"]


def check_fits(driver, width):
    wide = driver.execute_script("return document.documentElement.scrollWidth")
    assert wide <= width, f"the page is {wide} wide in a window of {width}"


def check_pointer(driver, program, spectral):
    picture = driver.find_element(By.ID, "picture")
    driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", picture)
    for right, down in ((-40, -30), (35, 20), (0, 45)):
        ActionChains(driver).move_to_element_with_offset(picture, right, down).click().perform()
    assert len(check_spectra(driver, program, spectral)) == 3


def check_keys(driver, program, spectral):
    picture = driver.find_element(By.ID, "picture")
    picture.send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_UP, Keys.ENTER)
    assert len(check_spectra(driver, program, spectral)) == 4
    picture.send_keys(Keys.ENTER)  # the same texel: unpinned
    assert len(shown_spectra(driver)) == 3


def pixel(driver):
    """Of the texel in the middle of the picture, as the canvas shows it."""
    return driver.execute_script(
        "const c = document.getElementById('relit'); return [...c.getContext('2d')"
        ".getImageData(c.width >> 1, c.height >> 1, 1, 1).data.slice(0, 3)]")


def relit_pixel(program, spectral, lamp, place):
    """The same as `specbake relight` writes it, read by Pillow."""
    picture = spectral.with_name(f"{lamp}.png")
    subprocess.run([program, "relight", spectral, "-o", picture, "--illuminant", lamp], check=True)
    return Image.open(picture).convert("RGB").getpixel(place)


def check_lamps(driver, program, spectral):
    middle = driver.execute_script(
        "const p = placeOf((report.rows >> 1) * report.columns + (report.columns >> 1)); return [p.x, p.y]")
    for lamp in ("A", "F11"):
        driver.execute_script(
            "for (const id of ['left-lamp', 'right-lamp']) { const one = document.getElementById(id);"
            "one.value = arguments[0]; one.dispatchEvent(new Event('change')); }", lamp)
        asked = relit_pixel(program, spectral, lamp, tuple(middle))
        off = max(abs(a - b) for a, b in zip(pixel(driver), asked))
        assert off <= 1, f"under {lamp} {pixel(driver)} where relight has {asked}"  # roundings to 8 bits


def check_split(driver):
    """At 0 all is the right lamp, at 100 all the left one."""
    set_split = ("const s = document.getElementById('split'); s.value = arguments[0];"
                 "s.dispatchEvent(new Event('input'));")
    choose = ("const one = document.getElementById(arguments[0]); one.value = arguments[1];"
              "one.dispatchEvent(new Event('change'));")
    driver.execute_script(choose, "left-lamp", "D65")
    driver.execute_script(choose, "right-lamp", "F2")
    seen = []
    for share in (0, 100):
        driver.execute_script(set_split, share)
        seen.append(driver.execute_script("return document.getElementById('relit').toDataURL()"))
    assert seen[0] != seen[1], "the border between the lamps does nothing"


def check_page(driver, program, spectral, page, width, scheme, pictures):
    resize(driver, width, scheme)
    open_page(driver, page)
    check_fits(driver, width)
    check_pointer(driver, program, spectral)
    check_keys(driver, program, spectral)
    check_lamps(driver, program, spectral)
    check_split(driver)
    if pictures:
        height = driver.execute_script("return document.documentElement.scrollHeight")
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        driver.save_screenshot(str(page.with_name(f"{width}-{scheme}.png")))
    check_no_complaints(driver)
    check_no_network(driver)


def hostile_name(folder):
    """A texture whose name would end a script, and would be one."""
    texture = folder / "<!--<script>alert(1)<\u2044script>{{data}}.png"
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes((40 * x) % 256 for x in range(3 * 120)) for _ in range(100))
    texture.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 120, 100, 8, 2, 0, 0, 0)) +
                        chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
    return texture


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--pictures", action="store_true")
    parser.add_argument("--texture", type=pathlib.Path, default=DEMO)
    a = parser.parse_args()
    work = a.work.resolve() / "pages"
    work.mkdir(parents=True, exist_ok=True)
    driver = browser()
    try:
        for texture in (a.texture, hostile_name(work)):
            folder = work / ("demo" if texture == a.texture else "hostile")
            folder.mkdir(exist_ok=True)
            spectral, page = folder / "spectral.exr", folder / "page.html"
            subprocess.run([a.program, "bake", "-q", texture, "-o", spectral, "--report", page], check=True)
            views = ((WIDE, "light"), (NARROW, "dark")) if texture == a.texture else ((NARROW, "light"),)
            for width, scheme in views:
                check_page(driver, a.program, spectral, page, width, scheme, a.pictures)
    finally:
        driver.quit()
    print("the page shows what is in the file")


main()
