import click
@click.command("notes")
def command():
    """todo"""
