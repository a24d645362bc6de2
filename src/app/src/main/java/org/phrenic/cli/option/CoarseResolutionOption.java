package org.phrenic.cli.option;

import org.phrenic.scenario.Assignment;
import picocli.CommandLine.Option;

/** The resolution of the bodies of a bench, low by default. */
public final class CoarseResolutionOption {
    @Option(names = "--resolution", paramLabel = "NAME", description = "low (default), medium or high.")
    private String resolution = "low";

    public Assignment assignment() {
        return Assignment.read("--resolution " + resolution, "resolution", resolution);
    }
}
