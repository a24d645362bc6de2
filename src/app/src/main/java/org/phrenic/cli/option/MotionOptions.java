package org.phrenic.cli.option;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.phrenic.document.CsvTable;
import org.phrenic.file.BadInputException;
import org.phrenic.motion.LungInside;
import org.phrenic.motion.MotionRequest;
import picocli.CommandLine.Option;

/** What {@code phrenic motion} writes, and for which times. */
public final class MotionOptions {
    private static final int MAX_PHASES = 1000;

    @Option(names = "--grid", paramLabel = "MM", description = "Displacement fields on voxels of this edge, as 3mm.")
    private String grid;

    @Option(
            names = "--points",
            paramLabel = "FILE",
            description = "CSV of points at rest (x_mm, y_mm, z_mm; name, structure); writes trajectories.csv.")
    private Path points;

    @Option(
            names = "--warp",
            paramLabel = "IMAGE",
            description = "An image of the body at rest, which breathes with it: NIfTI, NRRD or MetaImage.")
    private Path warp;

    @Option(names = "--labels", description = "The image holds labels: the nearest is taken.")
    private boolean labels;

    @Option(names = "--jacobian", description = "Also write the Jacobian, and the ventilation of the lungs.")
    private boolean jacobian;

    @Option(names = "--regions", description = "Also write the number of the region of each voxel of the grid.")
    private boolean regions;

    @Option(
            names = "--phases",
            paramLabel = "N",
            description = "So many times, spread evenly over a breath, a cycle (cheyne-stokes), a recording, or the "
                    + "whole of a scenario with a hold.")
    private String phases;

    @Option(names = "--at", paramLabel = "S[,S...]", description = "Simulated times, s.")
    private String at;

    @Option(
            names = "--times",
            paramLabel = "FILE",
            description = "CSV with a column time_s of simulated times, such as observables.csv.")
    private Path times;

    /** The times of --at or --times, in ascending order, once they are read. */
    private double[] stated;

    @Option(names = "--format", paramLabel = "EXT", description = "nii.gz (default), nii, nrrd or mha.")
    private String format = "nii.gz";

    @Option(
            names = "--lungs",
            paramLabel = "WAY",
            description = "vertices (default): inside lungs follows the vertices of their surface; elastic: only its "
                    + "shape, as in a fit.")
    private String lungs = "vertices";

    @Option(names = "--no-organs", description = "Leave out the organs that only move along; faster.")
    private boolean withoutOrgans;

    /** What to write; every value is checked. */
    public MotionRequest request() {
        lungs();
        int given = (phases == null ? 0 : 1) + (at == null ? 0 : 1) + (times == null ? 0 : 1);
        if (given != 1) {
            throw new BadInputException(
                    "motion: found " + given + " of --phases, --at and --times, expected one of them");
        }
        if (phases == null) {
            stated = sorted();
        } else {
            count();
        }
        double edge = grid == null
                ? 0
                : OptionValues.number("--grid", grid.toLowerCase(Locale.ROOT).replaceAll("\\s*mm$", ""), 0.5, 50);
        return new MotionRequest(edge, points, warp, labels, jacobian, regions, format);
    }

    /** The file of the times; null for none. */
    public Path timesFile() {
        return times;
    }

    public LungInside lungs() {
        return OptionValues.choice("--lungs", lungs, List.of(LungInside.values()));
    }

    public boolean organs() {
        return !withoutOrgans;
    }

    /**
     * The times in ascending order, s, after {@link #request}.
     *
     * @param breathS duration of a breath
     * @param lastS time of the last step of the scenario
     * @throws BadInputException if a time is negative or after the last step
     */
    public double[] times(double breathS, double lastS) {
        if (phases != null) {
            int count = count();
            return IntStream.range(0, count)
                    .mapToDouble(i -> i * breathS / count)
                    .toArray();
        }
        OptionValues.requireWithin(times != null ? "--times" : "--at", stated, lastS);
        return stated.clone();
    }

    private int count() {
        return OptionValues.integer("--phases", phases, 1, MAX_PHASES);
    }

    /** The times that are stated, one by one. */
    private double[] sorted() {
        double[] sorted = times == null
                ? OptionValues.times("--at", at)
                : Arrays.stream(CsvTable.read(times).numbers("time_s"))
                        .sorted()
                        .distinct()
                        .toArray();
        if (sorted.length == 0 || sorted.length > MAX_PHASES) {
            throw new BadInputException((times != null ? "--times" : "--at") + ": found " + sorted.length
                    + " times, expected 1 to " + MAX_PHASES);
        }
        return sorted;
    }
}
