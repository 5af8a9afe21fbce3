from probe_teller.teller import tell


def main():
    tell()
