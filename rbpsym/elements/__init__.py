"""The kinds of things of which a statement is made: shapes in one table, all others in a folder each.

A folder's own module is its data; beside it stand its law (`law`, for the mechanics), its virtual work (`work`, for Lagrange's
equations) and its row in the simulation (`row`), which share nothing but the statement.
"""
