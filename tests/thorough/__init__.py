"""The thorough tier: `make thorough` runs it, before an issue ends; `make test` leaves it out."""
