"""What stands behind the module System."""
