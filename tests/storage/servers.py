"""A PostgreSQL server of the tests' own: in a temporary folder, run by an unprivileged user."""

import os
import pwd
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Final

BINARIES: Final = Path("/usr/lib/postgresql")
"""Where Debian keeps them, a folder for each version."""
PORT: Final = 54991
"""Only part of the socket's name: the server listens on no network."""
START_S: Final = 60.0


def program(name: str) -> str:
    """The path of a program of PostgreSQL."""
    for folder in sorted(BINARIES.glob("*/bin"), reverse=True):
        if (folder / name).exists():
            return str(folder / name)
    found = shutil.which(name)
    assert found is not None, f"PostgreSQL's {name} is missing; `make setup` as root installs it"
    return found


class PostgresServer:
    """A server that is running."""

    def __init__(self) -> None:
        """Make a cluster and start it."""
        self.folder = Path(tempfile.mkdtemp(prefix="maestra-pg-"))
        self._user: str | None = None
        if os.getuid() == 0:
            # PostgreSQL refuses to run as root; Debian's package brings a user for it.
            self._user = "postgres"
            os.chown(self.folder, pwd.getpwnam(self._user).pw_uid, -1)
        self._run("initdb", "-D", self._data, "-A", "trust", "-U", "maestra", "--no-sync")
        self.start()

    @property
    def _data(self) -> str:
        return str(self.folder / "data")

    def start(self) -> None:
        """Start the server and wait until it answers."""
        # A killed process loses nothing that the kernel has, so the disk need not be waited for.
        options = (
            f"-p {PORT} -c fsync=off -c listen_addresses= -c unix_socket_directories={self.folder}"
        )
        log = str(self.folder / "log")
        self._run("pg_ctl", "-w", "-D", self._data, "-o", options, "-l", log, "start")

    def crash(self) -> None:
        """Kill all of its processes as the kernel would for want of memory, then start again."""
        leader = int((self.folder / "data" / "postmaster.pid").read_text().split()[0])
        os.kill(leader, signal.SIGKILL)
        deadline = time.monotonic() + START_S
        while True:
            try:
                self.start()
            except subprocess.CalledProcessError:
                # Its children must notice and let go of the memory that they share.
                assert time.monotonic() < deadline
            else:
                return

    def stop(self) -> None:
        """Stop it and remove its folder."""
        self._run("pg_ctl", "-D", self._data, "-m", "immediate", "stop")
        shutil.rmtree(self.folder)

    def new_database(self) -> str:
        """The URL of an empty database."""
        # Emptying one takes a hundredth of the time of making another.
        self.sql("DROP SCHEMA public CASCADE; CREATE SCHEMA public")
        return self.url

    @property
    def url(self) -> str:
        """The address of its database."""
        return f"postgresql://maestra@/postgres?host={self.folder}&port={PORT}"

    def sql(self, statement: str) -> str:
        """Run a statement; what psql prints."""
        arguments = ["-h", str(self.folder), "-p", str(PORT), "-U", "maestra", "-Atq"]
        return self._run("psql", *arguments, "-d", "postgres", "-c", statement)

    def _run(self, name: str, *arguments: str) -> str:
        done = subprocess.run(
            [program(name), *arguments],
            capture_output=name == "psql",
            stdin=subprocess.DEVNULL,
            stdout=None if name == "psql" else subprocess.DEVNULL,
            stderr=None if name == "psql" else subprocess.DEVNULL,
            text=True,
            check=True,
            cwd="/",
            user=self._user,
            group=self._user,
            extra_groups=None if self._user is None else [],
        )
        return done.stdout or ""
