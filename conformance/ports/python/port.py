"""A port of Dioptre, written from its specification: python3 port.py < requests > answers."""

import sys
import threading

sys.dont_write_bytecode = True

import protocol  # noqa: E402


if __name__ == "__main__":
    # objects nested in one another, 10,000 deep and more (limits.must-work)
    sys.setrecursionlimit(1000000)
    threading.stack_size(512 * 1024 * 1024)
    thread = threading.Thread(target=protocol.main)
    thread.start()
    thread.join()
