package org.phrenic.scenario;

import java.util.stream.Collectors;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.Materials;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.parameter.Parameter;

/** Documentation table of the parameters of all materials. */
public final class ParameterTable {
    private ParameterTable() {}

    /** The table in Markdown, the content of {@code docs/parameters.md}. */
    public static String markdown() {
        return Materials.parameters().stream()
                .map(p -> "| `" + p.key() + "` | " + p.unit() + " | " + NumberSetting.number(p.minimum()) + " to "
                        + NumberSetting.number(p.maximum()) + " | " + cell(p, Materials.PHYSICAL) + " | "
                        + cell(p, Materials.PAPER) + " | " + p.description() + " |\n")
                .collect(Collectors.joining(
                        "",
                        """
                        # Parameters

                        The numbers that can be tuned live, as keys of a scenario file or with `--set key=value`.
                        Those that are fixed at assembly: [a scenario](usage/run.md#a-scenario).
                        Values are defaults. The material `published` has those of `paper`.
                        "preset": the breathing preset gives it; "-": the material does not use it.
                        This table is made from the declarations of the parts that use them.

                        | key | unit | range | `physical` | `paper` | what it is |
                        |---|---|---|---|---|---|
                        """,
                        ""));
    }

    private static String cell(Parameter parameter, TissueMaterial material) {
        if (parameter.isGivenByPreset()) {
            return "preset";
        }
        return material.uses(parameter)
                ? NumberSetting.number(material.defaultOf(parameter, Scenario.defaults()))
                : "-";
    }
}
