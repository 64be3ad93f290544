"""One file a command of the terminal; each holds a click command called `command`."""
