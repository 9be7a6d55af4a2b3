"""Property tests: the same examples in every run, and no deadline that a busy machine could miss."""

from hypothesis import HealthCheck, settings

settings.register_profile(
    "workbook", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("workbook")
