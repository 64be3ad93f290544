"""`python -m rbpsym` is the command `rbpsym`."""

from rbpsym.cli import main

if __name__ == "__main__":
    main()
