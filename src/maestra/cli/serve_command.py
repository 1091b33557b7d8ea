"""The command that starts the web app; it is imported when it runs."""

from typing import Annotated

import typer

from maestra.cli.record_commands import Data, Keys


def serve(
    *,
    data: Data = None,
    keys: Keys = None,
    host: Annotated[
        str, typer.Option(metavar="ADDRESS", help="Where to listen; 0.0.0.0 is everywhere.")
    ] = "127.0.0.1",
    port: Annotated[
        int | None,
        typer.Option(
            metavar="NUMBER",
            min=0,
            max=65535,
            help="Which port.  [default: 8000, or a free one if it is taken]",
        ),
    ] = None,
    certificate: Annotated[
        str | None, typer.Option(metavar="FILE", help="Speak TLS with this certificate (PEM).")
    ] = None,
    key: Annotated[
        str | None, typer.Option(metavar="FILE", help="The certificate's private key (PEM).")
    ] = None,
    behind_proxy: Annotated[
        bool,
        typer.Option(
            "--behind-proxy",
            help="A proxy speaks TLS to the browsers and passes on Host and X-Forwarded-For.",
        ),
    ] = False,
    without_tls: Annotated[
        bool,
        typer.Option(
            "--without-tls-beyond-loopback",
            help="Let others connect without encryption: whoever is on the network can read "
            "passwords and what patients do, and act in anybody's name. Only for a network "
            "that is yours alone.",
        ),
    ] = False,
    recover: Annotated[
        bool,
        typer.Option(
            "--recover",
            help="Print a code that makes one more administrator, when no other can log in.",
        ),
    ] = False,
    open_browser: Annotated[
        bool, typer.Option("--open", help="Open a browser, if there is a display.")
    ] = False,
) -> None:
    """Serve the pages for caregivers and patients to browsers."""
    from maestra.cli.streams import print_lines
    from maestra.web import serving

    wanted = serving.Wanted(
        data,
        keys,
        host,
        port,
        certificate,
        key,
        behind_proxy,
        without_tls,
        recover,
        open_browser,
    )
    serving.serve(wanted, lambda line: print_lines([line]))
