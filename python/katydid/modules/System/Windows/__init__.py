"""System.Windows."""
