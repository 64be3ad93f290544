"""`rbpsym studio`: the page in which one states a problem and sees it derived as one types."""

from __future__ import annotations

from pathlib import Path

import click

from rbpsym.commands.arguments import FOLDER


@click.command("studio")
@click.option("--port", type=click.IntRange(0, 65535), default=0, help="Where it is served (0: a free port).")
@click.option("--browser/--no-browser", default=True, show_default=True, help="Open it in the browser.")
@click.option("--site", metavar="DIR", type=FOLDER, help="Where it was built, if elsewhere.")
def command(port: int, browser: bool, site: Path | None) -> int:
    """Serve the studio on this machine and open it; Ctrl-C ends it.

    \b
    Examples:
      rbpsym studio
      rbpsym studio --port 8000 --no-browser

    The engine runs in the page; nothing that is typed leaves the browser. The page is a wheel of its own, rbpsym-studio;
    in a checkout “make studio” builds it.
    """
    import webbrowser

    from rbpsym.studio.serving import HOST, server

    with server(port, site) as served:
        address = f"http://{HOST}:{served.server_address[1]}/"
        click.echo(f"{address}  (Ctrl-C ends it)")
        if browser:
            webbrowser.open(address)
        try:
            served.serve_forever()
        except KeyboardInterrupt:
            return 0
    return 0
