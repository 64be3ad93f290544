import click
@click.command("derive")
def command():
    """todo"""
