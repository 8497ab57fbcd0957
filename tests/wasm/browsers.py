"""Two browsers without windows, driven alike: Chromium by its DevTools protocol through a pipe, Firefox by Marionette."""
import base64
import json
import os
import pathlib
import socket
import subprocess
import time
import urllib.parse


kFramePath = "/frame"  # An empty page that the server of the test has.


class BrowserError(Exception):
    pass


class Chromium:
    name = "chromium"
    keys = {"Tab": ("Tab", 9, None), "Enter": ("Enter", 13, "\r"), "Space": (" ", 32, " "), "ArrowDown": ("ArrowDown", 40, None),
            "ArrowRight": ("ArrowRight", 39, None), "End": ("End", 35, None), "Backspace": ("Backspace", 8, None)}

    def __init__(self, program: str, home: pathlib.Path) -> None:
        to_browser, from_here = os.pipe()
        from_browser, to_here = os.pipe()

        def pipes() -> None:  # The browser reads from 3 and writes to 4.
            high = os.dup(to_here)
            os.dup2(to_browser, 3)
            os.dup2(high, 4)
            os.set_inheritable(3, True)
            os.set_inheritable(4, True)

        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
             "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", "--hide-scrollbars",
             f"--user-data-dir={home / 'chromium'}", "--remote-debugging-pipe", "about:blank"],
            preexec_fn=pipes, close_fds=False, env={**os.environ, "HOME": str(home)}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(to_here)
        self.out = os.fdopen(from_here, "wb", buffering=0)
        self.input = os.fdopen(from_browser, "rb", buffering=0)
        self.rest = b""
        self.count = 0
        self.session = ""
        page = next(t for t in self.ask("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        self.ask("Page.enable")

    def ask(self, method: str, **params):
        self.count += 1
        message = {"id": self.count, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        self.out.write(json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") != self.count:
                continue
            if "error" in answer:
                raise BrowserError(f"{method}: {answer['error']['message']}")
            return answer["result"]

    def receive(self):
        while b"\0" not in self.rest:
            piece = self.input.read(65536)
            if not piece:
                raise BrowserError("Chromium is gone")
            self.rest += piece
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def resize(self, width: int, height: int) -> None:
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 700)

    def go(self, address: str) -> None:
        self.ask("Page.navigate", url="about:blank")
        self.ask("Page.navigate", url=address)
        wait(lambda: self.run("return document.readyState === 'complete' && location.href !== 'about:blank'"), "the page is loaded")

    def run(self, body: str):
        """The value of the body of an asynchronous function."""
        answer = self.ask("Runtime.evaluate", expression=f"(async () => {{{body}}})()", awaitPromise=True, returnByValue=True, userGesture=True)
        if "exceptionDetails" in answer:
            raise BrowserError(answer["exceptionDetails"].get("exception", {}).get("description", "an exception"))
        return answer["result"].get("value")

    def press(self, *names: str) -> None:
        """Presses keys: names of special ones, or text to type."""
        for name in names:
            if name not in self.keys:
                self.ask("Input.insertText", text=name)
                continue
            key, code, text = self.keys[name]
            more = {"text": text} if text else {}
            for kind in ("keyDown" if text else "rawKeyDown", "keyUp"):
                self.ask("Input.dispatchKeyEvent", type=kind, key=key, code=name, windowsVirtualKeyCode=code, **(more if kind == "keyDown" else {}))

    def picture(self) -> bytes:
        return base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"])

    def close(self) -> None:
        self.session = ""
        self.ask("Browser.close")
        self.process.wait(30)


class Firefox:
    name = "firefox"
    keys = {"Tab": "\ue004", "Enter": "\ue007", "Space": " ", "ArrowDown": "\ue015", "ArrowRight": "\ue014", "End": "\ue010", "Backspace": "\ue003"}

    def __init__(self, program: str, home: pathlib.Path) -> None:
        profile = home / "firefox"
        profile.mkdir()
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        preferences = {"marionette.port": port, "datareporting.policy.dataSubmissionEnabled": False, "app.update.enabled": False,
                       "network.captive-portal-service.enabled": False, "browser.shell.checkDefaultBrowser": False,
                       "services.settings.server": "", "toolkit.telemetry.enabled": False, "accessibility.tabfocus": 7}
        (profile / "user.js").write_text("".join(f"user_pref({json.dumps(k)}, {json.dumps(v)});\n" for k, v in preferences.items()))
        self.process = subprocess.Popen(
            [program, "--headless", "--no-remote", "--marionette", "--profile", str(profile), "about:blank"],
            env={**os.environ, "HOME": str(home), "MOZ_HEADLESS_WIDTH": "1280", "MOZ_HEADLESS_HEIGHT": "900"},
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.socket = None

        def connect() -> bool:
            try:
                self.socket = socket.create_connection(("127.0.0.1", port))
            except OSError:
                return False
            return True

        wait(connect, "Firefox listens", 60)
        self.stream = self.socket.makefile("rb")
        self.receive()
        self.count = 0
        self.ask("WebDriver:NewSession", capabilities={"alwaysMatch": {"acceptInsecureCerts": False}})
        self.ask("WebDriver:SetTimeouts", script=120000)

    def receive(self):
        digits = b""
        while not digits.endswith(b":"):
            piece = self.stream.read(1)
            if not piece:
                raise BrowserError("Firefox is gone")
            digits += piece
        return json.loads(self.stream.read(int(digits[:-1])))

    def ask(self, method: str, **params):
        self.count += 1
        text = json.dumps([0, self.count, method, params]).encode()
        self.socket.sendall(str(len(text)).encode() + b":" + text)
        _, _, error, result = self.receive()
        if error:
            raise BrowserError(f"{method}: {error['message']}")
        return result

    def resize(self, width: int, height: int) -> None:
        self.size = (width, height)
        self.ask("WebDriver:SwitchToFrame", id=None)
        self.ask("WebDriver:SetWindowRect", width=width, height=height)
        inner = self.run("return [innerWidth, innerHeight]")
        self.ask("WebDriver:SetWindowRect", width=2 * width - inner[0], height=2 * height - inner[1])

    def go(self, address: str) -> None:
        self.ask("WebDriver:SwitchToFrame", id=None)
        self.ask("WebDriver:Navigate", url="about:blank")
        if self.size[0] >= 500:
            self.ask("WebDriver:Navigate", url=address)
            return
        # No window is narrower than 500 points, but a frame is.
        self.ask("WebDriver:Navigate", url=urllib.parse.urljoin(address, kFramePath))
        self.run(f"""const frame = document.createElement('iframe');
            frame.style = 'border: 0; position: fixed; left: 0; top: 0; width: {self.size[0]}px; height: {self.size[1]}px';
            await new Promise(loaded => {{ frame.onload = loaded; frame.src = {json.dumps(address)}; document.body.replaceChildren(frame); }})""")
        frame = self.ask("WebDriver:FindElement", using="css selector", value="iframe")["value"]
        self.ask("WebDriver:SwitchToFrame", element=next(iter(frame.values())))

    def run(self, body: str):
        answer = self.ask("WebDriver:ExecuteAsyncScript", args=[], sandbox=None, script=f"""
            const done = arguments[arguments.length - 1];
            (async () => {{{body}}})().then(value => done({{value}}), error => done({{error: String(error)}}));""")["value"]
        if "error" in answer:
            raise BrowserError(answer["error"])
        return answer.get("value")

    def press(self, *names: str) -> None:
        actions = []
        for name in names:
            for key in [self.keys[name]] if name in self.keys else name:
                actions += [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]
        self.ask("WebDriver:PerformActions", actions=[{"type": "key", "id": "keyboard", "actions": actions}])

    def picture(self) -> bytes:
        return base64.b64decode(self.ask("WebDriver:TakeScreenshot", full=False)["value"])

    def close(self) -> None:
        self.ask("Marionette:Quit", flags=["eForceQuit"])
        self.process.wait(30)


def wait(holds, what: str, seconds: float = 60) -> None:
    """Waits until a condition holds."""
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise BrowserError(f"in vain: {what}")
        time.sleep(0.05)
