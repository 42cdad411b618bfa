// SPDX-License-Identifier: Apache-2.0
#include <twum/io/publish.hpp>
#include <twum/studies/study_file.hpp>

#include <utility>

namespace twum::inline v0_1::studies {
namespace {

constexpr const char* kIntroduction = R"text(# The study file

A study file names a motor and asks a question about it. `twum init KIND` writes a study file to start from,
`twum check FILE` reports every error in it, and `twum run FILE` runs it. This page is the output of
`twum schema study --format markdown`. `twum schema study` writes the same as JSON Schema, for editors.

```yaml
twum: 1
motor: ring-60.yaml              # a path relative to the folder of this file, or the motor
set: {preload: 140 N}
study:
  kind: sweep
  variables:
    amplitude: {min: 0.8 um, max: 2.2 um, points: 8}
    preload: [100 N, 160 N, 220 N]
  sampling: grid
  metrics:
    - stall_torque
    - wear_intensity_at(80 rpm)
```

A quantity is written with its unit; a dimensionless one is a plain number. `NAME` stands for a [parameter](parameters.md), by
name or symbol; its values have its dimension and lie within its range. (Below `choose`, `NAME` is a name of your own.) Where a
[metric](metrics.md) may stand, a parameter may too. `[]` stands for every item of a list. The third column is the default of an
entry that is left out. The page of the [solvers](solvers.md) lists the options of each solver, which stand below `solver: options:`.

)text";

constexpr const char* kSampling = R"text(
| sampling | designs |
| --- | --- |
| `grid` | all combinations; the last variable changes fastest; `points` values of a range, both ends included |
| `list` | the first values of all variables, then the second ones, ...; all lists have one length |
| `lhs` | `samples` designs of a Latin hypercube: every range is divided into `samples` equal parts, and each part holds one design |
| `sobol` | the first `samples` points of the Sobol sequence, shifted by an amount that follows from the seed |

On a logarithmic scale, equal parts are equal parts of the logarithm. From a list of values, or a range of whole numbers such as
`wavelengths`, `lhs` and `sobol` draw each value equally often. On a logarithmic scale, the whole
number k has the share of the range from k to k + 1.
)text";

// The entries below `study:` for one kind, without `kind`, which is the heading.
Schema entries_of(StudyKind kind) {
  Schema schema = study_schema(kind);
  std::erase_if(schema.entries.own(),
                [](const SchemaEntry& entry) { return entry.name == "kind"; });
  return schema;
}

}  // namespace

std::string study_reference() {
  std::string text = kIntroduction;
  Schema file = study_file_schema();
  std::erase_if(file.entries.own(), [](const SchemaEntry& entry) { return entry.name == "study"; });
  for (SchemaEntry& entry : file.entries.own()) {
    if (entry.name != "motor") continue;
    entry.schema = Schema{};
    entry.schema.text = "a path relative to the folder of this file, or the entries of a motor";
    entry.schema.example = "ring-60.yaml";
  }
  text += markdown_table(file) + "\nBelow `study:` stand `kind` and the entries of that kind:\n";
  for (std::size_t i = 0; i < study_kinds().size(); ++i) {
    const auto kind = static_cast<StudyKind>(i);
    const Schema schema = entries_of(kind);
    text += "\n## " + std::string(to_string(kind)) + "\n\nAsks: " + schema.text + ".\n\n" +
            markdown_table(schema);
    if (kind == StudyKind::sweep) text += kSampling;
  }
  return text;
}

}  // namespace twum::inline v0_1::studies
