import click
@click.command("solve")
def command():
    """todo"""
