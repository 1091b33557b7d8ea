"""The library: every exercise that was taught, brought in or comes with Maestra."""
