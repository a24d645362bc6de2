package org.phrenic.motion;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.ExistingPath;
import org.phrenic.file.JavaMemory;
import org.phrenic.file.Numbers;
import org.phrenic.file.OutputException;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.io.image.VoxelFiles;
import org.phrenic.mesh.io.image.VoxelSeries;
import org.phrenic.mesh.voxel.VoxelBox;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.StepTimes;

/**
 * Breathes a body and writes its motion at some times: displacement fields forward and backward, trajectories, warped
 * images, Jacobian and ventilation. {@code motion.json} is written last and lists the files.
 */
public final class MotionExport {
    private static final String REPORT = "motion.json";
    /** How far the grid reaches beyond the body at rest, so that it covers the inspired body too, mm. */
    private static final double MARGIN_MM = 40;

    private static final double SHARE_OF_MEMORY = 0.7;
    /**
     * Bytes a voxel of the grid: two fields, of which one is written while the other is made, labels at rest and now,
     * and what Java leaves unused between large arrays.
     */
    private static final long BYTES_A_VOXEL = 40;
    /** Bytes a voxel of the image: image, warped image, labels at rest and now. */
    private static final long BYTES_AN_IMAGE_VOXEL = 16;
    /** A field has three numbers a voxel in one array. */
    private static final long MOST_VOXELS = Integer.MAX_VALUE / 3 - 1;

    private static final double PACKED = 0.5;

    /** Far less than a time step, far more than the rounding of a time, s. */
    private static final double ROUNDING_S = 1e-9;

    private final Simulation simulation;
    private final BodyMotion motion;
    private final MotionRequest request;
    private final Path out;
    private final SimulationRun.Progress progress;
    private final Optional<MovingImage> image;
    private final Optional<MotionSampler> grid;
    private final Optional<MotionPoints> points;
    private final List<Object> phases = new ArrayList<>();
    private final List<String> files = new ArrayList<>();

    /**
     * Prepares the body and reads what is to be carried.
     *
     * @param simulation at rest
     * @throws BadInputException if a file cannot be used, the image does not overlap the body, or the voxels do not fit
     *     into memory
     */
    public MotionExport(
            Simulation simulation,
            BodyMotion motion,
            MotionRequest request,
            Path out,
            SimulationRun.Progress progress) {
        this.simulation = simulation;
        this.motion = motion;
        this.request = request;
        this.out = out;
        this.progress = progress;
        image = Optional.ofNullable(request.image()).map(file -> new MovingImage(file, request.labels(), motion));
        image.ifPresent(i -> i.notes().forEach(progress::note));
        if (motion.surfaces().stream().noneMatch(s -> s.kind() == StructureKind.SKIN)) {
            progress.note("The body has no skin, so that its soft tissue counts as outside.");
        }
        long ofImage = image.map(i -> i.sampler().box().voxels()).orElse(0);
        long memory = Runtime.getRuntime().maxMemory();
        if (request.gridMm() > 0) {
            double[][] corners = corners(motion.bounds());
            double[] low = corners[0];
            double[] high = corners[1];
            double edge = request.gridMm();
            long voxels = 1;
            for (int axis = 0; axis < 3; axis++) {
                voxels *= (long) ((high[axis] - low[axis]) / edge) + 2;
            }
            checkMemory(voxels, ofImage, memory);
            grid = Optional.of(new MotionSampler(motion, VoxelBox.covering(low, high, edge)));
        } else {
            checkMemory(0, ofImage, memory);
            grid = Optional.empty();
        }
        points = Optional.ofNullable(request.points()).map(file -> new MotionPoints(file, motion));
    }

    /** Least and greatest corner of the grid about the box {@code b} of the body at rest, mm. */
    static double[][] corners(double[] b) {
        return new double[][] {
            {b[0] - MARGIN_MM, b[1] - MARGIN_MM, b[2] - MARGIN_MM},
            {b[3] + MARGIN_MM, b[4] + MARGIN_MM, b[5] + MARGIN_MM}
        };
    }

    /**
     * Refuses voxels for which there is no room.
     *
     * @param voxels of the grid; 0 without one
     * @param ofImage voxels of the image; 0 without one
     * @param memory what Java may use, bytes
     */
    static void checkMemory(long voxels, long ofImage, long memory) {
        if (voxels > MOST_VOXELS) {
            throw new BadInputException("--grid: found " + voxels + " voxels, expected at most " + MOST_VOXELS);
        }
        long forGrid = voxels * BYTES_A_VOXEL;
        long forImage = ofImage * BYTES_AN_IMAGE_VOXEL;
        if (forGrid + forImage > SHARE_OF_MEMORY * memory) {
            throw new BadInputException((forGrid >= forImage ? "--grid: found " + voxels : "--warp: found " + ofImage)
                    + " voxels, expected no more than fit into Java's memory of " + JavaMemory.inWords(memory));
        }
    }

    /** Bytes of all files of one time that are not packed: fields, warped image, Jacobian, ventilation, regions. */
    static long bytesATime(MotionRequest request, long ofGrid, long ofImage, int bytesAnImageVoxel) {
        long jacobian = request.jacobian() ? 2L * Float.BYTES : 0;
        long regions = request.regions() ? 1 : 0;
        return ofGrid * (6L * Float.BYTES + jacobian + regions)
                + ofImage * (bytesAnImageVoxel + (ofGrid == 0 ? jacobian : 0));
    }

    /** Refuses to begin what the disk has no room for. */
    private void checkSpace(int times) {
        double needed = (double) bytesATime(
                        request,
                        grid.map(g -> g.box().voxels()).orElse(0),
                        image.map(i -> i.sampler().box().voxels()).orElse(0),
                        image.map(MovingImage::bytesAVoxel).orElse(0))
                * times
                * (request.format().equals("nii") || request.format().equals("mha") ? 1 : PACKED);
        try {
            Path there = ExistingPath.nearest(out).orElse(out);
            long free = Files.getFileStore(there).getUsableSpace();
            if (needed > free) {
                throw new BadInputException(Numbers.format(
                        "--out %s: found %d MB of free space, expected about %.0f MB for %d times",
                        out, free >> 20, needed / (1 << 20), times));
            }
        } catch (IOException unknown) {
            throw new OutputException(out + ": free space cannot be read: " + unknown.getMessage(), unknown);
        }
    }

    /** Refuses times that are reached at one step, or that round to one file name. */
    private void requireApart(double[] times) {
        StepTimes steps = simulation.stepTimes();
        for (int i = 1; i < times.length; i++) {
            if (label(steps.nearestS(times[i])).equals(label(steps.nearestS(times[i - 1])))) {
                throw new BadInputException("motion: found the times " + times[i - 1] + " and " + times[i]
                        + " s, which give the same files, expected times that differ by 0.001 s and a time step or"
                        + " more");
            }
        }
    }

    /** A time in file names. */
    private static String label(double timeS) {
        return Numbers.format("%.3f", timeS);
    }

    /**
     * Breathes and writes.
     *
     * @param times simulated times in ascending order, s
     * @return what was written, as in {@code motion.json}
     */
    public OrderedValues write(double[] times) {
        requireApart(times);
        checkSpace(times.length);
        // That of an earlier motion would describe other files.
        AtomicFile.delete(out.resolve(REPORT));
        boolean series = image.isPresent() && request.format().startsWith("nii");
        if (series) {
            VoxelSeries warped = image.get().series(times, n -> {
                phase(times[n]);
                return image.get().warped();
            });
            String name = "warped." + request.format();
            VoxelFiles.write(out.resolve(name), warped);
            files.add(name);
        } else {
            for (double time : times) {
                phase(time);
            }
        }
        points.ifPresent(p -> {
            p.write(out.resolve("trajectories.csv"));
            files.add("trajectories.csv");
        });
        OrderedValues report = new OrderedValues()
                .with("from", "rest at end-expiration")
                .with("axes", "LPS in MetaImage, NRRD and CSV; RAS in NIfTI; mm")
                .with("phases", phases)
                .with("regions", request.regions() ? motion.regionNames() : List.of())
                .with("files", files)
                .with("notice", Disclaimer.TEXT);
        JsonWriter.write(out.resolve(REPORT), report);
        return report;
    }

    /** Breathes to a time and writes what belongs to it alone. */
    private void phase(double time) {
        long told = System.nanoTime();
        double reached = simulation.stepTimes().nearestS(time);
        while (simulation.time() < reached - ROUNDING_S) {
            simulation.step();
            if (System.nanoTime() - told > 1_000_000_000L) {
                told = System.nanoTime();
                progress.advanced(simulation.time(), time, 0);
            }
        }
        motion.update();
        String at = label(simulation.time());
        double[] error = motion.latticeError();
        OrderedValues values = new OrderedValues()
                .with("time_s", simulation.time())
                .with("lattice_error_mean_mm", error[0])
                .with("lattice_error_percentile_99_mm", error[1])
                .with("lattice_error_maximum_mm", error[2]);
        points.flatMap(p -> p.add(simulation.time())).ifPresent(off -> values.with("points_off_mean_mm", off.mean())
                .with("points_off_sd_mm", off.deviation())
                .with("points_off_percentile_95_mm", off.percentile95()));
        grid.ifPresent(g -> writeFields(g, at, values));
        image.ifPresent(i -> {
            i.sampler().update();
            if (grid.isEmpty() && request.jacobian()) {
                writeJacobian(i.sampler(), at, values);
            }
            if (!request.format().startsWith("nii")) {
                String name = "warped_at_" + at + "s." + request.format();
                VoxelFiles.write(out.resolve(name), i.frame());
                files.add(name);
            }
        });
        phases.add(values);
    }

    private void writeFields(MotionSampler sampler, String at, OrderedValues values) {
        sampler.update();
        write(
                sampler,
                3,
                sampler.forward(),
                "displacement_forward_from_0.000s_to_" + at + "s",
                field("0.000", at, true));
        write(
                sampler,
                3,
                sampler.backward(),
                "displacement_backward_from_" + at + "s_to_0.000s",
                field(at, "0.000", false));
        if (request.jacobian()) {
            writeJacobian(sampler, at, values);
        }
        if (request.regions()) {
            String name = "regions_at_" + at + "s";
            write(sampler, 1, sampler.regions(), name, Map.of(VoxelSeries.CONTENT, "regions at " + at + " s"));
        }
    }

    /** What a displacement field says of itself. NRRD's key of the type is that of 3D Slicer. */
    private static Map<String, String> field(String from, String to, boolean forward) {
        Map<String, String> about = new LinkedHashMap<>();
        about.put(VoxelSeries.CONTENT, "displacement mm from " + from + " s to " + to + " s");
        about.put("displacement field type", forward ? "modeling" : "resampling");
        about.put("displacement", "mm");
        about.put("from", from + " s");
        about.put("to", to + " s");
        return about;
    }

    private void writeJacobian(MotionSampler sampler, String at, OrderedValues values) {
        float[] jacobian = sampler.jacobian();
        int folded = 0;
        for (float j : jacobian) {
            folded += j <= 0 ? 1 : 0;
        }
        values.with("jacobian_not_positive_percent", 100.0 * folded / Math.max(1, sampler.voxelsInBody()));
        String times = " from 0.000 s to " + at + " s";
        write(
                sampler,
                1,
                jacobian,
                "jacobian_from_0.000s_to_" + at + "s",
                Map.of(VoxelSeries.CONTENT, "Jacobian determinant" + times));
        write(
                sampler,
                1,
                sampler.ventilation(jacobian),
                "ventilation_from_0.000s_to_" + at + "s",
                Map.of(VoxelSeries.CONTENT, "specific ventilation ml/ml" + times));
    }

    private void write(MotionSampler sampler, int components, float[] values, String name, Map<String, String> about) {
        String file = name + "." + request.format();
        ScalarType type = name.startsWith("regions") ? ScalarType.UINT8 : ScalarType.FLOAT32;
        VoxelFiles.write(out.resolve(file), VoxelSeries.of(sampler.box(), components, type, values, about));
        files.add(file);
    }
}
