"""The engine behind a page: strings in, strings out, without the command line, numpy or a network."""
