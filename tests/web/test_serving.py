"""Where the server listens, who may reach it, what it says, how it stops."""

import os
import re
import signal
import socket
import ssl
import subprocess
import sys
import threading
import urllib.request
import webbrowser
from collections.abc import Generator
from contextlib import contextmanager
from datetime import UTC, datetime, timedelta
from ipaddress import ip_address
from pathlib import Path

import pytest
from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec

from maestra.cli.program import describe
from maestra.core.faults import InvalidError
from maestra.storage.opening import open_store, place
from maestra.web import serving
from maestra.web.serving import Wanted, address_to_open, demand_safe, is_loopback
from tests.web.people import ADA

EVERYWHERE = "0.0.0.0"  # noqa: S104 - the tests say what must not be
PATIENCE_S = 60.0
"""A busy computer takes a while to start it."""


@pytest.fixture(scope="module")
def certificate(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A certificate for localhost, and its key."""
    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "localhost")])
    now = datetime.now(UTC)
    made = (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(name)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - timedelta(days=1))
        .not_valid_after(now + timedelta(days=1))
        .add_extension(
            x509.SubjectAlternativeName(
                [x509.DNSName("localhost"), x509.IPAddress(ip_address("127.0.0.1"))]
            ),
            critical=False,
        )
        .sign(key, hashes.SHA256())
    )
    folder = tmp_path_factory.mktemp("tls")
    (folder / "cert.pem").write_bytes(made.public_bytes(serialization.Encoding.PEM))
    (folder / "key.pem").write_bytes(
        key.private_bytes(
            serialization.Encoding.PEM,
            serialization.PrivateFormat.PKCS8,
            serialization.NoEncryption(),
        )
    )
    return folder / "cert.pem", folder / "key.pem"


# ---------------------------------------------------------------- who may reach it


@pytest.mark.parametrize(
    ("host", "expected"),
    [
        ("127.0.0.1", True),
        ("127.1.2.3", True),
        ("localhost", True),
        ("::1", True),
        (EVERYWHERE, False),
        ("::", False),
        ("192.168.1.5", False),
        ("maestra.local", False),
        ("localhost.example", False),
    ],
)
def test_what_only_this_computer_reaches(host: str, *, expected: bool) -> None:
    assert is_loopback(host) == expected


def test_others_reach_it_only_encrypted_or_when_told_so(certificate: tuple[Path, Path]) -> None:
    cert, key = map(str, certificate)
    for safe in (
        Wanted(),
        Wanted(host="::1", behind_proxy=True),
        Wanted(host=EVERYWHERE, certificate=cert, key=key),
        Wanted(host=EVERYWHERE, without_tls=True),
        Wanted(host=EVERYWHERE, without_tls=True, behind_proxy=True),
    ):
        demand_safe(safe)
    for unsafe in (Wanted(host=EVERYWHERE), Wanted(host="192.168.1.5", behind_proxy=True)):
        with pytest.raises(InvalidError, match="others can reach without encryption"):
            demand_safe(unsafe)


def test_a_certificate_without_its_key_is_refused(
    certificate: tuple[Path, Path], tmp_path: Path
) -> None:
    cert, key = map(str, certificate)
    with pytest.raises(InvalidError, match="--key: missing"):
        demand_safe(Wanted(certificate=cert))
    with pytest.raises(InvalidError, match="--certificate: missing"):
        demand_safe(Wanted(key=key))
    with pytest.raises(InvalidError, match="PEM"):
        demand_safe(Wanted(certificate=key, key=cert))
    with pytest.raises(FileNotFoundError, match=r"nothing\.pem"):
        demand_safe(Wanted(certificate=str(tmp_path / "nothing.pem"), key=key))


@pytest.mark.parametrize(
    ("wanted", "expected"),
    [
        (Wanted(), "http://localhost:81"),
        (Wanted(host="::1"), "http://[::1]:81"),
        (Wanted(host="127.0.0.2"), "http://127.0.0.2:81"),
        (Wanted(host="10.0.0.1", without_tls=True), "http://10.0.0.1:81"),
        (Wanted(host=EVERYWHERE, without_tls=True), f"http://{socket.gethostname()}:81"),
        (Wanted(host="10.0.0.1", certificate="c", key="k"), "https://10.0.0.1:81"),
        (Wanted(behind_proxy=True), "http://localhost:81"),
    ],
)
def test_the_address_is_what_a_browser_understands(wanted: Wanted, expected: str) -> None:
    assert address_to_open(wanted, 81) == expected


def test_a_display_is_where_a_window_can_be_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    assert not serving.has_display()
    monkeypatch.setenv("WAYLAND_DISPLAY", "wayland-0")
    assert serving.has_display()
    monkeypatch.delenv("WAYLAND_DISPLAY")
    monkeypatch.setattr(sys, "platform", "darwin")
    assert serving.has_display()


# ---------------------------------------------------------------- in this process


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[str]:
    """What was said; the server itself stops before it begins."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))

    def stop(server: object, _listener: object) -> None:
        assert server is not None

    monkeypatch.setattr(serving, "_run", stop)
    return []


def wanted(folder: Path, **changed: object) -> Wanted:
    data, keys = str(folder / "data"), str(folder / "keys")
    return Wanted(data, keys, **changed)  # type: ignore[arg-type] # whichever a test changes


def test_the_code_is_said_until_there_is_an_account_and_for_recovery(
    tmp_path: Path, said: list[str]
) -> None:
    serving.serve(wanted(tmp_path, port=0), said.append)
    assert any(re.search(r"/set-up and type this code.*[A-Z2-9]{4}-", line) for line in said)
    store = open_store(place(str(tmp_path / "data"), str(tmp_path / "keys")))
    store.access.add_account(ADA)
    store.close()
    said.clear()
    serving.serve(wanted(tmp_path, port=0), said.append)
    assert not any("code" in line for line in said)
    serving.serve(wanted(tmp_path, port=0, recover=True), said.append)
    assert any("type this code" in line for line in said)


def test_what_is_not_encrypted_or_is_behind_a_proxy_is_said(
    tmp_path: Path, said: list[str]
) -> None:
    serving.serve(wanted(tmp_path, host=EVERYWHERE, port=0, without_tls=True), said.append)
    assert any("Without encryption" in line for line in said)
    said.clear()
    serving.serve(wanted(tmp_path, port=0, behind_proxy=True), said.append)
    assert any("through your proxy" in line for line in said)
    assert not any("Without encryption" in line for line in said)


def test_a_browser_is_opened_where_it_can_be_seen(
    tmp_path: Path, said: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    monkeypatch.setattr(serving, "has_display", lambda: False)
    serving.serve(wanted(tmp_path, port=0, opens_browser=True), said.append)
    assert opened == []
    monkeypatch.setattr(serving, "has_display", lambda: True)
    serving.serve(wanted(tmp_path, port=0, opens_browser=True), said.append)
    assert len(opened) == 1
    assert f"Maestra is at {opened[0]}" in said


def test_another_port_is_taken_only_if_none_was_named(
    tmp_path: Path, said: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    with socket.create_server(("127.0.0.1", 0)) as busy:
        port = busy.getsockname()[1]
        monkeypatch.setattr(serving, "USUAL_PORT", port)
        serving.serve(wanted(tmp_path), said.append)
        assert not any(f":{port}" in line for line in said)
        with pytest.raises(OSError, match="in use") as refused:
            serving.serve(wanted(tmp_path, port=port), said.append)
        assert describe(refused.value) == f"127.0.0.1, port {port}: Address already in use"


def test_an_address_of_nobody_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InvalidError, match="--host"):
        serving.serve(wanted(tmp_path, host="no such name", without_tls=True), lambda _: None)
    with pytest.raises(OSError, match="assign"):
        serving.serve(wanted(tmp_path, host="192.0.2.1", without_tls=True), lambda _: None)


# ---------------------------------------------------------------- a process of its own


def command(folder: Path, *options: str) -> list[str]:
    where = ["--data", str(folder / "data"), "--keys", str(folder / "keys"), "--port", "0"]
    return [sys.executable, "-m", "maestra", "serve", *where, *options]


@contextmanager
def running(folder: Path, *options: str) -> Generator[tuple[subprocess.Popen[str], list[str]]]:
    """The program, once it has said that it can be stopped; and what it said until then."""
    environment = os.environ | {"XDG_CACHE_HOME": str(folder / "cache")}
    program = subprocess.Popen(
        command(folder, *options),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        bufsize=1,
        env=environment,
    )
    assert program.stdout is not None
    lines: list[str] = []
    watchdog = threading.Timer(PATIENCE_S, program.kill)
    watchdog.start()
    try:
        while not lines or "Ctrl-C" not in lines[-1]:
            lines.append(program.stdout.readline())
            assert lines[-1], lines
        yield program, lines
    finally:
        watchdog.cancel()
        program.kill()
        program.stdout.close()
        program.wait()


def fetched(url: str, context: ssl.SSLContext | None = None) -> tuple[str, dict[str, str]]:
    with urllib.request.urlopen(url, timeout=PATIENCE_S, context=context) as answer:  # noqa: S310 - ours
        return answer.read().decode(), {k.lower(): v for k, v in answer.headers.items()}


@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGINT])
def test_it_serves_until_it_is_stopped_and_leaves_the_record_whole(
    tmp_path: Path, how: signal.Signals
) -> None:
    with running(tmp_path) as (program, lines):
        found = re.search(r"Maestra is at (http://localhost:\d+)", lines[0])
        assert found is not None
        page, headers = fetched(f"{found[1]}/login")
        assert "Welcome to Maestra" in page
        assert "server" not in headers
        program.send_signal(how)
        rest, _ = program.communicate(timeout=PATIENCE_S)
        assert rest == "Stopped; everything is saved.\n"
        assert program.returncode == 0
    open_store(place(str(tmp_path / "data"), str(tmp_path / "keys"))).close()


def test_with_a_certificate_it_speaks_tls(tmp_path: Path, certificate: tuple[Path, Path]) -> None:
    cert, key = certificate
    with running(tmp_path, "--certificate", str(cert), "--key", str(key)) as (_, lines):
        found = re.search(r"Maestra is at (https://localhost:\d+)", lines[0])
        assert found is not None
        trusting = ssl.create_default_context(cafile=str(cert))
        page, headers = fetched(f"{found[1]}/login", trusting)
        assert "Welcome to Maestra" in page
        assert "max-age" in headers["strict-transport-security"]


def test_two_servers_do_not_write_the_same_record(tmp_path: Path) -> None:
    with running(tmp_path):
        second = subprocess.run(
            command(tmp_path),
            capture_output=True,
            text=True,
            check=False,
        )
        assert second.returncode == 2
        assert "in use by another Maestra" in second.stderr
        assert second.stderr.count("\n") == 1
