# SPDX-License-Identifier: Apache-2.0
"""Runs the searches of processes.py on two workers of Dask. For your own cluster, make the Client with its address."""
import twum
from distributed import Client, LocalCluster  # type: ignore[import]
from processes import best

if __name__ == "__main__":
    pressures = ["1.5 MPa", "2 MPa", "2.5 MPa", "3 MPa"]
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        for pressure, found in zip(pressures, client.gather(client.map(best, pressures))):
            print(f"{pressure}: {found.outcome}, {twum.engineering(found.motor.peak_power, 'W')}")
