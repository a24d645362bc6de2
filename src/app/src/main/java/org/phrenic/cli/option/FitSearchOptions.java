package org.phrenic.cli.option;

import picocli.CommandLine.Option;

/** Options for the length of a search of {@code phrenic fit} and for the breaths that it takes side by side. */
public final class FitSearchOptions {
    private static final int MAX_EVALUATIONS = 1_000_000;

    @Option(names = "--threads", paramLabel = "N", description = "Breaths side by side (default ${DEFAULT-VALUE}).")
    private String threads = "2";

    @Option(
            names = "--evaluations",
            paramLabel = "N",
            description = "At most so many breaths a fit (default ${DEFAULT-VALUE}).")
    private String evaluations;

    /** @param usual evaluations of a fit where the option is not given */
    public FitSearchOptions(int usual) {
        evaluations = Integer.toString(usual);
    }

    public int threads() {
        return OptionValues.threads(threads, 1);
    }

    public int evaluations() {
        return OptionValues.integer("--evaluations", evaluations, 1, MAX_EVALUATIONS);
    }
}
