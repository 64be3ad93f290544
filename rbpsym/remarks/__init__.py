"""What is worth saying of a result, each remark decided before it is said."""
