# SPDX-License-Identifier: Apache-2.0
"""Compresses a file as gzip does, without its name and time: compress.py FILE OUT"""
import gzip
import pathlib
import sys

data = pathlib.Path(sys.argv[1]).read_bytes()
pathlib.Path(sys.argv[2]).write_bytes(gzip.compress(data, compresslevel=9, mtime=0))
