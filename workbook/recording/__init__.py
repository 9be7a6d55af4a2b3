"""Define recordings, plans, and scripts as data.

A recording stores what a program did in a run, a plan says what to watch, and a script says what the judge sends. This
package uses no ROS.

Packages of all higher layers may import the modules `recording`, `plan`, `script`, and `machine`.
"""
