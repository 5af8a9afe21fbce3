"""Rules about xml."""
