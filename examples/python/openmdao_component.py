# SPDX-License-Identifier: Apache-2.0
"""A motor as a component of OpenMDAO, with exact derivatives: the most power at a pressure of at most 3 MPa."""
import openmdao.api as om
import twum


class MotorComponent(om.ExplicitComponent):
    def setup(self):  # names and SI units are those of twum.parameter_table() and twum.metric_table()
        self.add_input("preload", 160, units="N")
        self.add_input("amplitude", 1.6e-6, units="m")
        self.add_output("peak_power", units="W")
        self.add_output("max_pressure", units="Pa")
        self.declare_partials("*", "*")

    def compute(self, inputs, outputs):
        found = twum.evaluate(twum.Motor(), inputs, list(outputs.keys()))
        if found["status"][0] != "ok":
            raise om.AnalysisError(found["status"][0])
        for metric in outputs.keys():
            outputs[metric] = found[metric]

    def compute_partials(self, inputs, partials):
        found = twum.gradients(twum.Motor(), inputs, ["peak_power", "max_pressure"])
        for metric, slopes in found.items():
            for parameter in inputs.keys():
                partials[metric, parameter] = slopes[parameter]


if __name__ == "__main__":
    problem = om.Problem(driver=om.ScipyOptimizeDriver(optimizer="SLSQP", disp=False))
    motor = problem.model.add_subsystem("motor", MotorComponent())
    motor.add_design_var("preload", lower=60, upper=300, ref=100)
    motor.add_design_var("amplitude", lower=0.8e-6, upper=2.2e-6, ref=1e-6)
    motor.add_constraint("max_pressure", upper=3e6, ref=1e6)
    motor.add_objective("peak_power", ref=-1)
    problem.setup()
    problem.run_driver()
    print(*(f"{name} {problem['motor.' + name].item():.6g}" for name in ("peak_power", "preload", "amplitude")))
