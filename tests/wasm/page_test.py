#!/usr/bin/env python3
"""page_test.py SITE DATA CERTIFY [--chromium PROGRAM] [--firefox PROGRAM] [--pictures FOLDER]: the page of wasm/page in browsers without windows.

SITE is the folder that wasm/build makes, DATA is tests/data, CERTIFY is the program. On a wide and on a narrow screen somebody makes nets, drops files,
cancels, follows links, asks questions, and uses nothing but the keyboard. With --pictures the screens are kept as PNG, to be looked at.
"""
import argparse
import base64
import fractions
import functools
import hashlib
import http.server
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import threading

from browsers import BrowserError, Chromium, Firefox, kFramePath, wait


class Handler(http.server.SimpleHTTPRequestHandler):
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".mjs": "text/javascript", ".wasm": "application/wasm"}

    requested: list[str] = []
    has_service_worker = False  # But for the test of it: what a service worker has kept nobody asks for.
    is_down = False
    altered = ""  # A file that is not of the version that the service worker is of.

    def do_GET(self):
        if self.is_down or (self.path == kServiceWorker and not self.has_service_worker):
            self.send_error(503)
            return
        self.requested.append(self.path)
        if self.path == self.altered:
            self.send_response(200)
            self.send_header("Content-Type", "text/css")
            self.end_headers()
            self.wfile.write(b"/* Another version. */")
            return
        if self.path != kFramePath:
            super().do_GET()
            return
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(b"<!DOCTYPE html><title>a frame</title><body></body>")

    def end_headers(self):
        self.send_header("Cache-Control", "no-store")  # So that `requested` has all that a page uses.
        super().end_headers()

    def log_message(self, *_):
        pass


class Server(http.server.ThreadingHTTPServer):
    def handle_error(self, *_):
        """Browsers hang up when they leave a page."""


# What a first net does not need of the module.
kDeferred = "/module.deferred.wasm"
kServiceWorker = "/service.js"


class Page:
    """The page in one browser, on one screen."""

    def __init__(self, browser, address: str, size: tuple[int, int], pictures: pathlib.Path | None) -> None:
        self.browser, self.address, self.size, self.pictures = browser, address, size, pictures
        self.failures: list[str] = []

    def expect(self, holds, what: str) -> None:
        if not holds:
            self.failures.append(what)

    def run(self, body: str):
        return self.browser.run(body)

    def text(self, id: str) -> str:
        return self.run(f"return document.getElementById({json.dumps(id)}).textContent")

    def click(self, id: str) -> None:
        self.run(f"document.getElementById({json.dumps(id)}).click()")

    def set(self, id: str, value: str) -> None:
        self.run(f"""const box = document.getElementById({json.dumps(id)}); box.value = {json.dumps(value)};
                     for (const type of ['input', 'change']) box.dispatchEvent(new Event(type, {{bubbles: true}}))""")

    def open(self, hash: str = "") -> None:
        """With the example that is there on arrival, or what the link says."""
        self.arrive(hash)
        self.rest("what is there on arrival")

    def arrive(self, hash: str = "") -> None:
        self.browser.go(self.address + hash)
        wait(lambda: self.run("return document.getElementById('commands').textContent !== ''"), "the page is there")

    def rest(self, what: str) -> None:
        wait(lambda: self.run("return document.getElementById('cancel').disabled"), f"{what} ends", 240)

    def verdicts(self) -> dict[str, str]:
        """What the page says of each checker."""
        return self.run("""const rows = [...document.querySelectorAll('#certificate-text dt')];
            return Object.fromEntries(rows.map(row => [row.textContent, row.nextSibling.textContent]))""")

    def drop(self, name: str, content: bytes) -> None:
        self.begin_drop(name, content)
        self.rest(name)

    def begin_drop(self, name: str, content: bytes) -> None:
        self.run(f"""const bytes = Uint8Array.from(atob({json.dumps(base64.b64encode(content).decode())}), c => c.charCodeAt(0)), data = new DataTransfer();
            data.items.add(new File([bytes], {json.dumps(name)}));
            for (const type of ['dragover', 'drop']) document.getElementById('make').dispatchEvent(new DragEvent(type, {{bubbles: true, cancelable: true, dataTransfer: data}}))""")

    def saved(self, button: str) -> bytes:
        """The bytes of the file that a button offers."""
        return base64.b64decode(self.run(f"""const {{createObjectURL}} = URL, {{click}} = HTMLAnchorElement.prototype;
            let file = null;
            URL.createObjectURL = blob => {{ file = blob; return createObjectURL(blob); }};
            HTMLAnchorElement.prototype.click = () => {{}};
            [...document.querySelectorAll('button')].find(button => button.textContent === {json.dumps(button)}).click();
            HTMLAnchorElement.prototype.click = click;
            URL.createObjectURL = createObjectURL;
            let text = '';
            for (const byte of new Uint8Array(await file.arrayBuffer())) text += String.fromCharCode(byte);
            return btoa(text)"""))

    def place_of_work(self) -> str:
        """After what progress and Cancel stand: its id, or the ids of the buttons in it."""
        return self.run("""const place = document.getElementById('work').previousElementSibling;
            return place.id || [...place.querySelectorAll('button')].map(button => button.id).join(' ')""")

    def keep(self, name: str) -> None:
        if self.pictures is not None:
            (self.pictures / f"{self.browser.name}-{self.size[0]}-{name}.png").write_bytes(self.browser.picture())


def first_net(page: Page, certify: str) -> None:
    Handler.requested.clear()
    page.arrive()
    page.keep("start")
    page.expect(page.run("return innerWidth") == page.size[0], "the screen is not as wide as it should be")
    visible = page.run("return [document.getElementById('verdict').textContent, document.getElementById('cancel').disabled]")
    page.expect(visible[0] == "" or visible[1], "a verdict before anything was proved")
    page.rest("the example")
    page.expect(page.text("verdict") == "VERIFIED" and "An example, octagon 123" in page.text("work-text"), f"the example: {page.text('work-text')}")
    page.expect(page.place_of_work() == "buttons", f"progress of a net is after {page.place_of_work()}")
    is_open = page.run("return document.getElementById('legend').open && document.querySelector('#legend ul').getClientRects().length > 0")
    page.expect(is_open == (page.size[0] > 860), "the legend does not fold on a small screen, or does on a large one")
    if not is_open:
        page.run("document.querySelector('#legend summary').click()")
    page.expect(page.run("return document.activeElement === document.body && location.hash === ''"), "the example took the focus or the address")
    page.set("seed", "124")
    page.click("start")
    page.rest("a net")
    page.expect(page.text("verdict") == "VERIFIED", f"the first net: {page.text('verdict')} {page.text('problem')}")
    said = page.verdicts()
    for checker in ("certify", "certify-exact"):
        page.expect(said.get(checker, "").startswith("VERIFIED"), f"{checker} says {said.get(checker)}")
    net = page.saved("Save the net")
    page.expect(hashlib.sha256(net).hexdigest() == said.get("SHA-256"), "the net that is saved is not the one that was checked")
    answer = subprocess.run([certify, "-"], input=net, stdout=subprocess.PIPE, check=False)
    page.expect(answer.returncode == 0, f"the program says of the saved net: {answer.stdout.decode()[-200:]}")
    page.expect(page.saved("Save the certificate").decode().splitlines()[-1] == "VERIFIED", "the saved certificate")
    page.expect(re.match("[0-9]{3,} triangles in view", page.text("status")), f"the picture says {page.text('status')}")
    page.expect(page.run("return document.getElementById('legend').open"), "the legend that was opened is not open on the next picture")
    page.keep("verified")
    page.expect(kDeferred not in Handler.requested, "the first net loaded the whole module")
    page.expect(page.run("""return performance.getEntriesByType('resource').every(entry => new URL(entry.name).origin === location.origin || entry.name.startsWith('data:'))"""),
                "something was asked from elsewhere")


def example_makes_room(page: Page) -> None:
    """Whoever asks for something while the example is made gets it."""
    page.arrive()
    page.set("seed", "7")
    page.click("start")
    wait(lambda: "octagon 7" in page.text("certificate-heading"), "a net that is asked for during the example")
    page.rest("that net")
    page.expect("seed=7" in page.run("return location.hash"), "the address after an example that made room")


def questions(page: Page) -> None:
    page.click("systole")
    page.rest("the systole")
    page.expect(kDeferred in Handler.requested, "the systole did not load the rest of the module")
    page.expect(page.run("return [...document.querySelectorAll('#systole small, #eigenvalues small')].every(cost => /^[0-9]+ s$/.test(cost.textContent))"),
                "no times beside questions")
    page.set("count", "9")
    page.expect(page.run("return document.querySelector('#eigenvalues small').textContent") == "", "a time that nobody measured")
    page.set("count", "1")
    page.expect("systole" in page.place_of_work(), f"progress of the systole is after {page.place_of_work()}")
    page.expect("closed geodesic" in page.text("answered") and "VERIFIED" in page.text("answered"), f"the systole: {page.text('answered')} {page.text('problem')}")
    page.expect(page.run("return document.getElementById('geodesics').options.length > 0"), "the systole is not drawn")
    page.click("take")
    # Two points near the centre: a click at one, and Enter at another one.
    page.run("""const canvas = document.getElementById('view'), box = canvas.getBoundingClientRect();
        for (const type of ['pointerdown', 'pointerup'])
          canvas.dispatchEvent(new PointerEvent(type, {bubbles: true, pointerId: 1, clientX: box.left + box.width / 2 + 31, clientY: box.top + box.height / 2 - 17}));
        canvas.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter', bubbles: true, cancelable: true}))""")
    page.rest("a distance")
    page.expect("the distance is " in page.text("answered"), f"the distance: {page.text('answered')[:200]} {page.text('problem')}")
    page.keep("questions")
    page.set("up-to", "3.5")
    page.click("spectrum")
    page.rest("the spectrum")
    colours = page.run("""return [...document.querySelectorAll('#layers label')].filter(row => row.textContent.includes('closed geodesics'))
        .map(row => [row.textContent, row.querySelector('.mark').style.background])""")
    page.expect(len({colour for name, colour in colours if "shortest" in name}) == 1 and len({colour for _, colour in colours}) == 2,
                f"systole and other geodesics are not told apart: {colours}")
    # A click on a closed geodesic asks what it meets. The one chosen here is drawn, in the middle of the picture.
    page.click("take")
    page.run("""const list = document.getElementById('geodesics');
        list.selectedIndex = list.options.length - 1;
        list.dispatchEvent(new Event('change'))""")
    page.rest("what the geodesic that is chosen in the list meets")
    page.expect("What a closed geodesic meets" in page.text("answered") and re.search("curves 0 and [0-9] meet", page.text("answered")),
                f"a geodesic that is chosen in the list: {page.text('answered')[:300]} {page.text('problem')}")
    page.run("document.getElementById('answered').replaceChildren()")
    # The picture moves there.
    wait(lambda: page.run("""const canvas = document.getElementById('view'), box = canvas.getBoundingClientRect();
        for (const type of ['pointerdown', 'pointerup'])
          canvas.dispatchEvent(new PointerEvent(type, {bubbles: true, pointerId: 1, clientX: box.left + box.width / 2, clientY: box.top + box.height / 2}));
        return document.getElementById('answered').textContent.includes('What a closed geodesic meets')"""), "a geodesic that is clicked")
    page.rest("what the geodesic that is clicked meets")
    page.expect("curve 0: length" in page.text("answered"), f"a geodesic that is clicked: {page.text('answered')[:300]} {page.text('problem')}")


def eigenvalues(page: Page) -> None:
    """Eigenvalues, and eigenfunctions of those that are simple. Progress and Cancel are where the question was asked."""
    page.open("#seed=5&epsilon=0.5")
    ask = lambda digits: (page.set("digits", digits), page.click("eigenvalues"))
    ask("9")
    page.expect(page.place_of_work() == "eigenvalues", f"progress of eigenvalues is after {page.place_of_work()}")
    page.expect(page.run("const {left, right, width} = document.getElementById('cancel').getBoundingClientRect(); return width > 0 && left >= 0 && right <= innerWidth"),
                "Cancel cannot be seen")
    page.keep("asked")
    page.click("cancel")
    page.rest("eigenvalues that are cancelled")
    page.expect("cancelled" in page.text("work-text") and page.place_of_work() == "eigenvalues", f"cancelled: {page.text('work-text')}")
    page.set("count", "2")
    ask("2")
    page.rest("eigenvalues of two digits")
    page.expect("from 3 digits on" in page.text("answered") and "Draw the" not in page.text("answered"), f"eigenfunctions of two digits: {page.text('answered')[:300]}")
    ask("3")
    page.rest("eigenvalues of three digits")
    page.expect("λ₁ is " in page.text("answered"), f"eigenvalues: {page.text('answered')[:300]} {page.text('problem')}")
    page.run("[...document.querySelectorAll('#answered button')].find(button => button.textContent === 'Draw the eigenfunction of λ₁').click()")
    page.expect(page.run("return document.getElementById('work').closest('article') !== null"), "progress of an eigenfunction is not with its eigenvalue")
    page.rest("an eigenfunction")
    page.expect("The eigenfunction of λ₁" in page.text("work-text"), f"an eigenfunction: {page.text('work-text')} {page.text('problem')}")
    page.expect('class="nodal-lines"' in page.saved("Save the picture").decode(), "the picture of an eigenfunction has no nodal lines")
    wait(lambda: page.run("return document.querySelector('#answered img').naturalWidth > 0"), "the picture of an eigenfunction")
    page.run("document.querySelector('#answered img').scrollIntoView()")
    page.keep("eigenfunction")
    # The first one of Bolza's surface is triple.
    page.open("#name=bolza&epsilon=0.5")
    ask("3")
    page.rest("an eigenvalue of Bolza's surface")
    page.expect("λ₁ to λ₃ are 3.83" in page.text("answered") and "Draw the" not in page.text("answered"), f"Bolza's eigenvalues: {page.text('answered')[:300]}")


def bounds(page: Page) -> None:
    """Diameter and radius, and where they are attained."""
    page.open("#seed=5&epsilon=0.5")
    for id in ("diameter", "radius"):
        page.click(id)
        page.rest(id)
        point = page.run("const point = document.querySelector('#answered details'); return [point.querySelector('summary').textContent, point.querySelector('p').textContent]")
        rounded, exact = (re.search(pattern, text) for pattern, text in zip((r"at p: tile ([0-9]+), \((.*), (.*)\)$", "^([0-9]+),([-0-9/]+),([-0-9/]+)$"), point))
        page.expect(rounded and exact, f"the point of the {id}: {point} {page.text('problem')}")
        if rounded and exact:
            page.expect(rounded[1] == exact[1] and all(abs(fractions.Fraction(rounded[k]) - fractions.Fraction(exact[k])) <= fractions.Fraction(1, 2 * 10**12) for k in (2, 3)),
                        f"the point of the {id} is not as its fractions: {point}")
    page.set("p", point[1])
    page.set("q", "0")
    page.click("distance")
    page.rest("the distance of a point of the radius")
    page.expect("the distance is " in page.text("answered"), f"the point of a radius is no point: {page.text('problem')}")
    page.expect("distance" in page.place_of_work(), f"progress of a distance is after {page.place_of_work()}")


def symmetries(page: Page) -> None:
    """Isometries, pairs of pants, Dirichlet domains; and surfaces made of others."""
    page.open("#name=bolza&epsilon=1/3")
    page.expect("1/3" in page.verdicts().get("epsilon", ""), f"ε is not as it was given: {page.verdicts()}")
    for id, text in (("isometries", "48 preserve the orientation: 1 of order 1"), ("pants", "cuff 2, of pants 0 and 1"), ("dirichlet", "8 sides")):
        page.click(id)
        page.rest(id)
        page.expect(text in page.text("answered"), f"{id}: {page.text('answered')[:200]} {page.text('problem')}")
    page.set("words", "0, 1 1")
    page.click("curves")
    page.rest("closed curves")
    for text in ("simple, class (", "curve 1: length", "a power, 2", "curves 0 and 1 meet "):
        page.expect(text in page.text("answered"), f"closed curves: {page.text('answered')[:300]} {page.text('problem')}")
    wait(lambda: page.run("return [...document.querySelectorAll('#answered img')].every(image => image.complete)"), "pictures of answers")
    page.expect(page.run("return [...document.querySelectorAll('#answered img')].filter(image => image.naturalWidth > 0).length") == 3, "no pictures of answers")
    page.set("words", "0; 1")
    page.click("curves")
    page.expect("expected the numbers of the sides" in page.text("problem"), f"curves that are no words: {page.text('problem')}")
    page.run("document.getElementById('answered').scrollIntoView()")
    page.keep("answers")
    page.run("scrollTo(0, 0)")
    # The coordinates of the pants become those of the form; the graph shows which cuff is which.
    page.run("[...document.querySelectorAll('#answered button')].find(button => button.textContent.startsWith('Take these')).click()")
    page.expect(page.run("return document.getElementById('surface').value") == "fenchel-nielsen" and page.text("of-before") != "", "the coordinates of pants")
    wait(lambda: page.run("return document.querySelectorAll('#pants-graph g').length") == 3, "a picture of the graph of pants")
    page.run("document.querySelectorAll('#pants-graph g')[1].dispatchEvent(new MouseEvent('click', {bubbles: true}))")
    page.expect(page.run("return document.querySelectorAll('.cuff')[1].open && document.querySelectorAll('#pants-graph g')[1].classList.contains('chosen')"),
                "the graph does not lead to its cuffs")
    page.keep("cuffs")
    page.click("start")
    page.rest("the surface of pants")
    page.expect(page.text("verdict") == "VERIFIED", f"the surface of pants: {page.text('problem')}")
    # A cover and twists, and the link to them.
    page.open("#seed=5&epsilon=0.5")
    page.expect(page.run("return document.getElementById('twist').disabled"), "a twist without a curve")
    page.click("cover")
    page.rest("a cover")
    page.expect(page.text("verdict") == "VERIFIED" and "steps=cover%3A2%3A1" in page.run("return location.hash"), f"a cover: {page.text('problem')}")
    page.expect("--degree 2 --seed 1 -o s1.json" in page.text("commands"), f"the commands of a cover: {page.text('commands')}")
    page.run("document.querySelector('#steps button').click()")
    page.expect(page.text("of-before") != "" and page.run("return document.getElementById('steps').children.length") == 0, "a step that is removed")
    page.click("start")
    page.rest("the surface again")
    page.click("systole")
    page.rest("its systole")
    for id, value in (("dehn-twist", "-2"), ("twist", "1/2")):
        page.set("power" if id == "dehn-twist" else "by", value)
        page.click(id)
        page.rest(id)
        page.expect(page.text("verdict") == "VERIFIED" and f"{id}%3A" in page.run("return location.hash"), f"{id}: {page.text('problem')}")
        page.run("history.back()")
        wait(lambda: page.run("return document.getElementById('steps').children.length") == 0 and page.text("verdict") == "VERIFIED", "the way back")
        page.rest("the way back")
        page.click("systole")
        page.rest("its systole")
    page.set("degree", "x")
    page.click("cover")
    page.expect("cover:x:1: expected a cover or a twist" in page.text("problem"), f"a cover with x sheets: {page.text('problem')}")
    # Families of named surfaces, of any genus, and graphs that fit to the genus.
    page.open("#name=wiman-7&epsilon=0.9")
    page.expect(page.text("verdict") == "VERIFIED" and page.run("return document.getElementById('name-genus').value") == "7", f"wiman-7: {page.text('problem')}")
    page.set("name-genus", "5")
    page.click("start")
    page.rest("wiman-5")
    page.expect("genus 5" in page.run("return document.getElementById('facts').textContent") or "wiman-5" in page.text("certificate-heading"), "wiman-5")
    # Maps of the census, by a link and by the form.
    page.open("#name=R2.1&epsilon=0.5&colour=red")
    page.expect(page.text("verdict") == "VERIFIED" and "R2.1" in page.text("certificate-heading"), f"R2.1: {page.text('problem')}")
    page.expect(page.text("of-link") == "not in the link, so as usual: kind; in the link without meaning for this surface: colour",
                f"fields of a link: {page.text('of-link')}")
    page.set("map", "C7.1")
    page.set("epsilon", "0.9")
    page.click("start")
    page.rest("C7.1")
    page.expect(page.text("verdict") == "VERIFIED" and "name=C7.1" in page.run("return location.hash"), f"C7.1: {page.text('problem')}")
    page.expect(page.text("of-link") == "", "what was said of a link is said of another surface")
    for name in ("R2.99", "bolzano"):
        page.open(f"#name={name}")
        page.expect(f'there is no surface "{name}"' in page.text("problem") and page.text("verdict") == "", f"{name}: {page.text('problem')}")
        page.expect("epsilon, kind" in page.text("of-link"), "fields of a link to no surface")
    page.open("#genus=2&graph=theta&epsilon=0.5")
    page.expect(page.text("verdict") == "VERIFIED", f"theta: {page.text('problem')}")
    page.set("genus", "3")
    page.expect(page.run("return document.getElementById('graph').value") == "chain", "theta has no genus 3")


def offline(page: Page) -> None:
    """After the first visit the page works without a network: also what it has not loaded before. Files of two versions are not kept."""
    page.open()
    Handler.has_service_worker = True
    try:
        Handler.altered = "/page.css"
        state = page.run("""const {installing} = await navigator.serviceWorker.register('service.js');
            await new Promise(done => { installing.onstatechange = () => { if (installing.state !== 'installing') done(); }; });
            return installing.state""")
        page.expect(state == "redundant", f"a service worker with a file of another version is {state}")
        Handler.altered = ""
        page.open()
        page.run("await navigator.serviceWorker.ready")
        wait(lambda: page.run("return navigator.serviceWorker.controller !== null"), "the service worker is in charge")
        Handler.is_down = True
        page.open("#seed=9&epsilon=0.5")
        page.expect(page.text("verdict") == "VERIFIED", f"without a network: {page.text('verdict')} {page.text('problem')}")
        page.click("systole")
        page.rest("a systole without a network")
        page.expect("closed geodesic" in page.text("answered"), f"a systole without a network: {page.text('problem')}")
    finally:
        Handler.is_down = Handler.has_service_worker = False
        Handler.altered = ""
        page.run("""for (const registration of await navigator.serviceWorker.getRegistrations()) await registration.unregister();
            for (const name of await caches.keys()) await caches.delete(name)""")


def files(page: Page, data: pathlib.Path) -> None:
    page.open()
    forged = (data / "certify/refuted/covering-epsilon-too-small.json").read_bytes()
    page.drop("forged.json", forged)
    said = page.verdicts()
    page.expect(page.text("verdict") == "REFUTED", f"a forged file is {page.text('verdict')} {page.text('problem')}")
    for checker in ("certify", "certify-exact"):
        page.expect(said.get(checker, "").startswith("REFUTED"), f"of a forged file {checker} says {said.get(checker)}")
    page.expect(said.get("SHA-256") == hashlib.sha256(forged).hexdigest(), "the hash of a forged file")
    page.expect(page.run("return document.getElementById('questions').hidden"), "questions to a net that is refuted")
    page.keep("refuted")
    page.drop("nonsense.json", b"{\"format\": 1, \xff}")
    page.expect(page.text("verdict") == "MALFORMED", f"nonsense is {page.text('verdict')} {page.text('problem')}")
    page.drop("true.json", (data / "certify/verified/octagon-1-vertex.json").read_bytes())
    page.expect(page.text("verdict") == "VERIFIED", f"a true file is {page.text('verdict')} {page.text('problem')}")
    page.expect(page.run("return !document.querySelector('#surface [value=file]').disabled"), "the surface of a file cannot be chosen")
    page.drop("surface.json", (data / "surfaces/cuff-1e-28.json").read_bytes())
    page.expect(page.text("verdict") == "NO CLAIM" and page.run("return document.getElementById('surface').value") == "file",
                f"a surface file is {page.text('verdict')} {page.text('problem')}")
    page.run("history.back()")
    wait(lambda: page.text("verdict") == "VERIFIED", "the way back leads to the true file")
    page.rest("the true file again")
    page.drop("spectrum.json", (data / "geodesics/octagon-5-to-6.json").read_bytes())
    page.expect(page.text("verdict") == "VERIFIED" and page.run("return document.getElementById('geodesics').options.length > 0"),
                f"a file of geodesics is {page.text('verdict')}, and not drawn: {page.text('problem')}")
    page.drop("pants.json", (data / "pants/octagon-5.json").read_bytes())
    said = page.verdicts()
    page.expect(page.text("verdict") == "VERIFIED" and said.get("certify", "") == said.get("certify-exact", "") == "VERIFIED",
                f"a pants file is {page.text('verdict')}: {said} {page.text('problem')}")
    page.expect(page.place_of_work() == "drop", f"progress of a file is after {page.place_of_work()}")
    # Files that claim nothing, and are of no surface.
    page.run("document.getElementById('surface').value = 'octagon'; document.querySelector('#surface [value=file]').disabled = true")
    for name, content in (("domain.json", b'{"format":"epsnet-dirichlet","version":1}'), ("matrices.json", b'{"format":"epsnet-matrices","version":1}'),
                          ("picture.svg", b'<svg xmlns="http://www.w3.org/2000/svg"></svg>'), ("picture.png", b"\x89PNG\r\n\x1a\n"),
                          ("page.html", b"<!DOCTYPE html><html></html>"), ("mesh.msh", b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n")):
        page.drop(name, content)
        claim = page.verdicts().get("claim", "")
        page.expect(page.text("verdict") == "NO CLAIM" and claim.startswith("none: ") and "claims nothing" in claim, f"{name} is {page.text('verdict')}: {page.verdicts()}")
        page.expect(page.run("return document.querySelector('.verdict.verified, .verdict.malformed, #verdict.verified') === null"), f"{name} looks like a verdict")
        page.expect(page.run("return document.getElementById('surface').value === 'octagon' && document.querySelector('#surface [value=file]').disabled"),
                    f"{name} was opened as a surface")
    # A domain of CGAL claims nothing, too, and has a surface.
    page.drop("polygon.txt", (data / "polygons/polygon-g2-small.txt").read_bytes())
    page.expect(page.text("verdict") == "NO CLAIM" and page.run("return document.getElementById('surface').value") == "file",
                f"a domain of CGAL is {page.text('verdict')}: {page.text('problem')}")
    page.click("start")
    page.rest("a net of it")
    page.expect(page.text("verdict") == "VERIFIED", f"the net of a domain of CGAL: {page.text('problem')}")
    # A file that is too large takes the place of what was there.
    page.run("""const megabyte = new Uint8Array(1e6), data = new DataTransfer();
        data.items.add(new File([...Array(64).fill(megabyte), 'x'], 'large.json'));
        document.getElementById('make').dispatchEvent(new DragEvent('drop', {bubbles: true, cancelable: true, dataTransfer: data}))""")
    page.expect("large.json has more than 64 MB" in page.text("problem") and "certify large.json" in page.text("problem"), f"a large file: {page.text('problem')}")
    page.expect(page.text("verdict") == "" and page.run("""return ['certificate', 'questions', 'panel'].every(id => document.getElementById(id).hidden) &&
        document.getElementById('picture').classList.contains('past')"""), "beside a large file there is what was there before")


def bad_input(page: Page) -> None:
    page.open()
    for epsilon in ("0", "-1", "abc", "", "NaN"):
        page.set("epsilon", epsilon)
        page.click("start")
        page.rest(f"ε = {epsilon}")
        page.expect(page.text("verdict") == "" and page.text("problem") != "", f"ε = '{epsilon}': {page.text('verdict')} {page.text('problem')}")
    page.set("epsilon", "0.5")
    page.click("start")
    page.rest("ε = 0.5")
    page.expect(page.text("verdict") == "VERIFIED", f"ε = 0.5: {page.text('verdict')} {page.text('problem')}")
    page.set("epsilon", "abc")
    page.click("start")
    page.rest("ε = abc")
    page.expect(page.text("verdict") == "" and page.run("return document.getElementById('certificate').hidden"), "a verdict of before beside an error")
    page.set("epsilon", "0.001")
    page.click("start")
    page.expect("epsnet net s.json --epsilon 0.001" in page.text("problem"), f"too much: {page.text('problem')}")
    page.set("epsilon", "0.0001")
    page.click("start")
    page.expect("million vertices" in page.text("problem") and "epsnet net" not in page.text("problem"), f"too much: {page.text('problem')}")
    page.open("#seed=5&epsilon=1e-9")
    page.expect("10¹⁸ vertices" in page.text("problem") and "epsnet net" not in page.text("problem"), f"far too much: {page.text('problem')}")
    page.open("#surface=octagon&seed=<img>&epsilon=0.1&kind=net")
    page.expect(page.run("return document.getElementById('seed').value") == "123", "an address with nonsense is followed")
    page.expect("seed=<img>" in page.text("problem"), f"what is wrong with an address: {page.text('problem')}")


def cancel(page: Page) -> None:
    page.open()
    page.set("epsilon", "0.01")
    page.click("start")
    page.begin_drop("early.json", b"{}")
    page.expect("One thing at a time" in page.text("problem"), "a file that is dropped meanwhile is silently forgotten")
    page.click("cancel")
    page.rest("what is cancelled")
    page.expect("cancelled" in page.text("work-text") and page.text("verdict") == "", f"cancelled: {page.text('work-text')} {page.text('verdict')}")
    page.set("epsilon", "0.5")
    page.click("start")
    page.rest("the net after it")
    page.expect(page.text("verdict") == "VERIFIED", f"after cancelling: {page.text('verdict')} {page.text('problem')}")


def second_checker(page: Page) -> None:
    """It is not asked about large nets, unless somebody wants it."""
    page.open("#seed=5&epsilon=0.025")
    page.expect("more than" in page.verdicts().get("certify-exact", ""), f"the second checker of a large net: {page.verdicts()} {page.text('problem')}")
    page.run("[...document.querySelectorAll('#certificate-text button')].find(button => button.textContent === 'Ask it').click()")
    page.expect(page.place_of_work() == "certificate-text", f"progress of the second checker is after {page.place_of_work()}")
    page.click("cancel")
    page.rest("the second checker that is cancelled")
    page.expect("cancelled" in page.text("work-text"), f"the second checker, cancelled: {page.text('work-text')}")


def link(page: Page) -> None:
    page.open("#surface=fenchel-nielsen&genus=2&graph=chain&lengths=1.5,2,0.75&twists=0.5,-1,0&epsilon=0.3&kind=sparse")
    page.rest("a link")
    values = {id: page.run(f"return document.getElementById('{id}').value")
              for id in ("surface", "genus", "length-0", "length-2", "twist-1", "epsilon", "kind")}
    page.expect(list(values.values()) == ["fenchel-nielsen", "2", "1.5", "0.75", "-1", "0.3", "sparse"], f"a link restores {values}")
    page.expect(page.text("verdict") == "VERIFIED", f"the net of a link: {page.text('verdict')} {page.text('problem')}")
    page.keep("link")
    before = page.run("return location.hash")
    page.set("length-0", "1.6")
    page.expect(page.text("of-before") != "", "the form says something else than the picture, and nobody says so")
    page.click("copy-link")
    wait(lambda: "the link is" in page.text("work-text"), "a link that is copied")
    page.expect(page.place_of_work() == "buttons", f"that a link is copied is said after {page.place_of_work()}")
    page.expect(page.run("return location.hash") == before.replace("1.5", "1.6"), f"the link is {page.run('return location.hash')}")


def keyboard(page: Page) -> None:
    """From the top of the page with Tab, Enter and letters."""
    page.open()
    press = page.browser.press

    def tab_to(id: str) -> None:
        for _ in range(60):
            press("Tab")
            if page.run("return document.activeElement.id") == id:
                page.expect(page.run("return parseFloat(getComputedStyle(document.activeElement).outlineWidth) >= 2"), f"{id} does not show the focus")
                return
        raise BrowserError(f"Tab does not lead to {id}")

    tab_to("seed")
    press("End", "Backspace", "Backspace", "Backspace", "77")
    tab_to("start")
    press("Enter")
    page.rest("a net by keys")
    page.expect(page.text("verdict") == "VERIFIED" and "seed=77" in page.run("return location.hash"), f"by keys: {page.text('verdict')} {page.text('problem')}")
    tab_to("view")
    press("Enter")
    page.expect("vertex" in page.text("status"), f"Enter in the picture says {page.text('status')}")
    tab_to("systole")
    press("Enter")
    page.rest("a systole by keys")
    page.expect("closed geodesic" in page.text("answered"), "no systole by keys")
    page.expect(page.run("return document.activeElement.id") == "systole", "the focus is not where it was before the work")


def layout(page: Page) -> None:
    page.expect(page.run("return document.documentElement.scrollWidth <= innerWidth"), "the page is wider than the screen")
    wide = page.run("""return [...document.querySelectorAll('button, input, select, p, pre, h2, label')].filter(e => e.getClientRects().length > 0 &&
        e.getBoundingClientRect().right > innerWidth + 1).map(e => e.id || e.textContent.slice(0, 30)).join(', ')""")
    page.expect(wide == "", f"beyond the edge of the screen: {wide}")
    nameless = page.run("""return [...document.querySelectorAll('button, input, select, canvas, textarea')].filter(e => !(e.ariaLabel || e.getAttribute('aria-label') ||
        (e.labels && e.labels[0] && e.labels[0].textContent.trim()) || e.textContent.trim() || e.getAttribute('aria-labelledby'))).map(e => e.id || e.outerHTML.slice(0, 60)).join(', ')""")
    page.expect(nameless == "", f"without a name: {nameless}")
    twice = page.run("""const ids = [...document.querySelectorAll('[id]')].map(e => e.id); return ids.filter((id, k) => ids.indexOf(id) !== k).join(', ')""")
    page.expect(twice == "", f"ids that come twice: {twice}")
    faint = page.run(kContrast)
    page.expect(faint == "", f"hard to read: {faint}")


# Contrast of text with the colour behind it, as the Web Content Accessibility Guidelines define it.
kContrast = """
const channels = colour => colour.match(/[0-9.]+/g).map(Number), bad = [];
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
  const element = node.parentElement;
  if (node.data.trim() === '' || element.getClientRects().length === 0 || element.closest('script, noscript, option, :disabled')) continue;
  let behind = element;
  while (behind !== document.documentElement && channels(getComputedStyle(behind).backgroundColor)[3] === 0) behind = behind.parentElement;
  const ratio = contrast(channels(getComputedStyle(element).color).slice(0, 3), channels(getComputedStyle(behind).backgroundColor).slice(0, 3));
  if (ratio < 4.5) bad.push(`${node.data.trim().slice(0, 20)} (${ratio.toFixed(1)})`);
}
return bad.join(', ')"""


def run_all(browser, address: str, data: pathlib.Path, certify: str, pictures: pathlib.Path | None) -> int:
    count = 0
    for size in ((1280, 900), (390, 844)):
        browser.resize(*size)
        page = Page(browser, address, size, pictures)
        parts = [lambda: first_net(page, certify), lambda: layout(page), lambda: questions(page), lambda: layout(page), lambda: example_makes_room(page),
                 lambda: eigenvalues(page), lambda: layout(page), lambda: bounds(page), lambda: symmetries(page), lambda: layout(page), lambda: files(page, data), lambda: bad_input(page), lambda: cancel(page), lambda: second_checker(page),
                 lambda: link(page), lambda: layout(page), lambda: keyboard(page), lambda: offline(page)]
        for part in parts:
            try:
                part()
            except BrowserError as error:
                page.failures.append(str(error))
        for failure in page.failures:
            print(f"FAILED: {browser.name}, {size[0]} pixels: {failure}")
        if not page.failures:
            print(f"passed: {browser.name}, {size[0]} pixels")
        count += len(page.failures)
    return count


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("site", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("certify")
    parser.add_argument("--chromium")
    parser.add_argument("--firefox")
    parser.add_argument("--pictures", type=pathlib.Path)
    options = parser.parse_args()
    if options.pictures is not None:
        options.pictures.mkdir(parents=True, exist_ok=True)
    server = Server(("127.0.0.1", 0), functools.partial(Handler, directory=options.site))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    browsers = [(kind, program) for kind, program in ((Chromium, options.chromium), (Firefox, options.firefox)) if program]
    if not browsers:
        parser.error("--chromium or --firefox is needed")
    failures = 0
    for kind, program in browsers:
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
            browser = kind(program, pathlib.Path(home))
            try:
                failures += run_all(browser, f"http://127.0.0.1:{server.server_port}/", options.data, options.certify, options.pictures)
            finally:
                browser.close()
    server.shutdown()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
