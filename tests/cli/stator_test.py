# SPDX-License-Identifier: Apache-2.0
"""stator: modal data and circuit, free and under load."""
import json
import math
import pathlib

import program
from program import DRIVE, RING


class Stator(program.Case):
    def answer(self, *arguments):
        return json.loads(self.ok("stator", *arguments, "--format", "json"))

    def test_the_circuit_is_the_published_one(self):
        # Figures published for this motor, to their digits.
        circuit = self.answer(DRIVE)["equivalent_circuit"]
        self.assertAlmostEqual(circuit["motional_resistance"], 132, delta=0.5)
        self.assertAlmostEqual(circuit["motional_inductance"], 82.6e-3, delta=0.05e-3)
        self.assertAlmostEqual(circuit["motional_capacitance"], 0.2015e-9, delta=0.5e-13)
        self.assertAlmostEqual(circuit["series_resonance"], 39e3, delta=1e-6)
        self.assertAlmostEqual(circuit["parallel_resonance"], 39460, delta=1)

    def test_a_motor_from_its_circuit_is_the_same_motor(self):
        answer = self.answer(DRIVE)
        units = answer["units"]
        lines = "".join(f"      {name}: {answer['equivalent_circuit'][name]!r} {units[name]}\n"
                        for name in ("motional_resistance", "motional_inductance", "motional_capacitance",
                                     "blocked_capacitance"))
        kept = [line for line in pathlib.Path(DRIVE).read_text().splitlines(True)
                if line.split(":")[0].strip() not in ("resonance_frequency", "modal_mass", "quality_factor",
                                                      "blocked_capacitance")]
        text = "".join(kept).replace("    force_factor:", f"    equivalent_circuit:\n{lines}      force_factor:")
        again = self.answer(self.write("circuit.yaml", text))
        # Mass, frequency and quality factor go through some ten roundings, which the running wave magnifies little.
        for block in ("modal_data", "under_load"):
            for name, value in answer[block].items():
                if isinstance(value, float):
                    self.assertAlmostEqual(again[block][name] / value, 1, delta=1e-11, msg=name)

    def test_the_circuit_under_load_takes_the_terminals_power(self):
        for load in (("--torque", "0.5 N.m"), ("--speed", "60 rpm")):
            answer = self.answer(DRIVE, *load)
            at, modal = answer["under_load"], answer["modal_data"]
            circuit = at["equivalent_circuit"]
            omega = 2 * math.pi * answer["motor"]["frequency"]
            branch = complex(circuit["motional_resistance"],
                             omega * circuit["motional_inductance"] - 1 / (omega * circuit["motional_capacitance"]))
            blocked = omega * circuit["blocked_capacitance"] * complex(modal["loss_tangent"], 1)
            current = at["voltage"] * (blocked + 1 / branch)
            # Kirchhoff on the printed values; the reactances cancel to some per cent of each.
            self.assertAlmostEqual(abs(current) / at["phase_current"], 1, delta=1e-11)
            self.assertAlmostEqual(2 * at["voltage"] * current.real / at["electrical_power"], 1, delta=1e-10)

    def test_the_best_point_is_the_default(self):
        best = self.answer(DRIVE)["under_load"]
        for speed in (0.98 * best["speed"], 1.02 * best["speed"]):
            beside = self.answer(DRIVE, "--speed", f"{speed!r} rad/s")["under_load"]
            self.assertLess(beside["overall_efficiency"], best["overall_efficiency"])

    def test_an_amplitude_with_modal_data_has_its_voltage(self):
        driven = self.answer(DRIVE, "--speed", "100 rpm")["under_load"]
        given = self.answer(DRIVE, "--speed", "100 rpm", "--set", f"amplitude={driven['amplitude']!r} m")["under_load"]
        # The amplitude found and the voltage that it takes are inverse to each other.
        self.assertAlmostEqual(given["voltage"], 120, delta=1e-9)

    def test_without_preload_it_is_a_stator_without_rotor(self):
        answer = self.answer(DRIVE, "--set", "preload=0 N")
        motor, modal, free = answer["motor"], answer["modal_data"], answer["without_rotor"]
        omega, resonance = 2 * math.pi * motor["frequency"], 2 * math.pi * modal["resonance_frequency"]
        stiffness = complex(modal["modal_mass"] * (resonance ** 2 - omega ** 2), omega * modal["modal_damping"])
        displacement = modal["force_factor"] * math.sqrt(2) * motor["voltage"] / stiffness
        # k - omega^2 m is a tenth of k, and the balance is solved to 1e-11.
        self.assertAlmostEqual(free["amplitude"] / abs(displacement), 1, delta=1e-9)
        blocked = modal["blocked_capacitance"] * complex(1, -modal["loss_tangent"]) * motor["voltage"]
        current = 1j * omega * (blocked + modal["force_factor"] * displacement / math.sqrt(2))
        self.assertAlmostEqual(free["phase_current"] / abs(current), 1, delta=1e-9)
        self.assertAlmostEqual(free["electrical_power"] / (2 * motor["voltage"] * current.real), 1, delta=1e-8)
        text = self.ok("stator", DRIVE, "--set", "preload=0 N")
        self.assertIn("without rotor", text)
        self.assertNotIn("under load", text)

    def test_what_is_missing_is_said(self):
        self.assertIn("ring-60.yaml: this motor has no modal data; give resonance_frequency", self.refused("stator", RING))
        error = self.refused("stator", DRIVE, "--torque", "5 N.m", status=1)
        self.assertIn("no answer at this torque: unreachable", error)
        self.assertIn("--torque", self.refused("stator", DRIVE, "--torque", "5 N"))
        self.refused("stator", DRIVE, "--torque", "0.5 N.m", "--speed", "1 rpm")
        still = program.twum("stator", DRIVE, "--set", "voltage=30 V", "--set", "modal_damping=300 N.s/m")
        self.assertEqual(still.returncode, 0)
        self.assertNotIn("under load", still.stdout.decode())
        self.assertIn("no operating point under load: no-running-branch", still.stderr)


if __name__ == "__main__":
    program.main()
