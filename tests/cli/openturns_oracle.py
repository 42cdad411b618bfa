#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shares of failures and Sobol indices against OpenTURNS, where it is installed (Debian: python3-openturns).

    openturns_oracle.py TWUM

On its plateau the elastic motor has the stall torque mu F r exactly, so that OpenTURNS needs no motor. It gets its own laws, copula,
FORM and importance sampling; the two programs share the formula of the torque only.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

try:
    import openturns
except ImportError:
    print("OpenTURNS is not installed: nothing compared")
    sys.exit(0)

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOTOR = ROOT / "examples/motors/elastic-layer.yaml"
RADIUS, PRELOAD, FRICTION, THICKNESS = 0.0265, 160.0, 0.17, 3e-4


def run(twum, folder, name, study):
    """summary.json of a study."""
    path = folder / (name + ".yaml")
    path.write_text(f"twum: 1\nmotor: {MOTOR}\nstudy:\n{study}")
    subprocess.run([twum, "run", str(path), "-o", str(folder / name)], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return json.loads((folder / name / "summary.json").read_text())


def laws(kind):
    """The entries of a study, and the same two laws of preload and friction."""
    if kind == "normal":
        return "preload: 3 %, kinetic_friction: {mean: 0.17, sd: 10 %}", [
            openturns.Normal(PRELOAD, 0.03 * PRELOAD), openturns.Normal(FRICTION, 0.1 * FRICTION)]
    if kind == "lognormal":
        law = openturns.LogNormalMuSigma
        entry = "{{distribution: lognormal, mean: {}, sd: {} %}}"
        return "preload: " + entry.format("160 N", 5) + ", kinetic_friction: " + entry.format(0.17, 10), [
            openturns.ParametrizedDistribution(law(PRELOAD, 0.05 * PRELOAD)),
            openturns.ParametrizedDistribution(law(FRICTION, 0.1 * FRICTION))]
    if kind == "bounded":
        preload = openturns.TruncatedDistribution(openturns.Normal(PRELOAD, 8.0), 130.0, 190.0)
        mean, sd, a, b = FRICTION, 0.015, 0.1, 0.25
        share = (mean - a) / (b - a)
        n = share * (1 - share) * ((b - a) / sd) ** 2 - 1
        return ("preload: {distribution: truncated, sd: 8 N, from: 130 N, to: 190 N}, "
                "kinetic_friction: {distribution: beta, mean: 0.17, sd: 0.015, from: 0.1, to: 0.25}"), [
            preload, openturns.Beta(share * n, (1 - share) * n, a, b)]
    scale = openturns.ParametrizedDistribution(openturns.WeibullMinMuSigma(PRELOAD, 0.2 * PRELOAD, 0.0))
    return ("preload: {distribution: weibull, sd: 20 %}, kinetic_friction: {mean: 0.17, sd: 10 %}"), [
        scale, openturns.Normal(FRICTION, 0.1 * FRICTION)]


def reference(marginals, correlation, torque):
    """Share of failures by importance sampling about the design point, its standard error, and the index of FORM."""
    matrix = openturns.CorrelationMatrix(2)
    matrix[0, 1] = correlation
    joint = openturns.ComposedDistribution(marginals, openturns.NormalCopula(matrix))
    motor = openturns.SymbolicFunction(["F", "mu"], [f"{RADIUS} * F * mu"])
    vector = openturns.RandomVector(joint)
    event = openturns.ThresholdEvent(openturns.CompositeRandomVector(motor, vector), openturns.Less(), torque)
    optimizer = openturns.AbdoRackwitz()
    optimizer.setMaximumAbsoluteError(1e-10)
    optimizer.setMaximumConstraintError(1e-10)
    form = openturns.FORM(optimizer, event, joint.getMean())
    form.run()
    result = form.getResult()
    standard = openturns.StandardEvent(event)
    importance = openturns.Normal(result.getStandardSpaceDesignPoint(), openturns.CovarianceMatrix(2))
    sampling = openturns.ProbabilitySimulationAlgorithm(standard, openturns.ImportanceSamplingExperiment(importance))
    sampling.setBlockSize(1000)
    sampling.setMaximumOuterSampling(100)
    sampling.setMaximumCoefficientOfVariation(0.005)
    sampling.run()
    estimate = sampling.getResult()
    share = estimate.getProbabilityEstimate()
    return share, math.sqrt(estimate.getVarianceEstimate()), result.getHasoferReliabilityIndex()


def compare_shares(twum, folder):
    """Four pairs of laws, two correlations, shares of failures from 1e-2 to 1e-9."""
    wrong = 0
    for kind in ["normal", "lognormal", "bounded", "weibull"]:
        entries, marginals = laws(kind)
        for correlation in [0.0, 0.6]:
            for part in [0.7, 0.55]:
                torque = round(part * RADIUS * PRELOAD * FRICTION, 6)
                pair = f"  correlations: [[preload, kinetic_friction, {correlation}]]\n" if correlation else ""
                answer = run(twum, folder, f"{kind}-{correlation}-{part}",
                             f"  kind: uncertainty\n  method: importance\n  variables: {{{entries}}}\n{pair}"
                             f"  limits: [stall_torque >= {torque} N.m]\n")
                share, error, index = reference(marginals, correlation, torque)
                own = answer["failing"]["share"]
                half = own["high"] - own["value"]
                # Half widths are 2.1 standard errors; four of both together hold in all but 6 of 100,000 cases.
                room = 4 * math.hypot(half / 2.131, error)
                far = abs(own["value"] - share) > room or abs(answer["limits"][0]["index"] - index) > 1e-3 * index
                wrong += far
                print(f"{kind}, correlation {correlation}: share {own['value']:.4g} (OpenTURNS {share:.4g}), index "
                      f"{answer['limits'][0]['index']:.5f} ({index:.5f}){'  DIFFERS' if far else ''}")
    return wrong


def compare_indices(twum, folder):
    """Shares of variance of a product of three laws, by Martinez' estimator."""
    entries, marginals = laws("lognormal")
    answer = run(twum, folder, "sobol",
                 f"  kind: sensitivity\n  method: sobol\n  samples: 4096\n  tolerances: {{{entries}, thickness: {{range: 50 %}}}}\n"
                 "  metrics: [stall_torque * (1 + 5 * thickness / (1 mm))]\n")
    marginals.append(openturns.Uniform(0.5 * THICKNESS, 1.5 * THICKNESS))
    function = openturns.SymbolicFunction(["F", "mu", "h"], [f"{RADIUS} * F * mu * (1 + 5 * h / 1e-3)"])
    indices = openturns.MartinezSensitivityAlgorithm(openturns.ComposedDistribution(marginals), 1 << 17, function, False)
    first, total = indices.getFirstOrderIndices(), indices.getTotalOrderIndices()
    wrong = 0
    for j, name in enumerate(["preload", "kinetic_friction", "thickness"]):
        own = next(iter(answer["indices"].values()))[name]
        for key, other in (("first", first[j]), ("total", total[j])):
            # Plain sampling of 131,072 rows has a standard error of about 0.003; half widths are 3.2 of twum's.
            room = 4 * math.hypot((own[key]["high"] - own[key]["value"]) / 3.182, 0.003)
            far = abs(own[key]["value"] - other) > room
            wrong += far
            print(f"{name} {key}: {own[key]['value']:.4f} (OpenTURNS {other:.4f}){'  DIFFERS' if far else ''}")
    return wrong


def main():
    twum = sys.argv[1]
    openturns.RandomGenerator.SetSeed(1)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        wrong = compare_shares(twum, folder) + compare_indices(twum, folder)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
