package org.phrenic.access.ultrasound;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.phrenic.access.TargetLesion;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * B-mode ultrasound of the moving body, from its surfaces. Five levels across the thickness of the beam cut the
 * surfaces in curves; every scan line is followed through the tissues between its exact crossings with these curves
 * ({@link LineWalk}); scatterers and interfaces are blurred by the point spread of the probe ({@link PointSpread}),
 * raised by the time-gain compensation, compressed logarithmically and scan-converted. The bits of an image depend on
 * the frame, the probe and the settings alone, not on the number of threads nor on earlier images.
 *
 * <p>Method and sources: {@code docs/ultrasound.md}. An instance is used by one thread at a time.
 */
public final class Ultrasound {
    /** Intensity that is white at a gain of 0 dB, dB of a perfect mirror in front of the face. */
    private static final double WHITE_DB = -22;
    /** Greatest time-gain compensation, dB. */
    private static final double MAX_DEPTH_GAIN_DB = 90;

    private static final int LOG_BITS = 12;
    private static final float[] LOG2 = logarithms();

    private final CurvilinearProbe probe;
    private final int threads;
    private final List<SonatedSurface> surfaces = new ArrayList<>();
    private final List<String> leftOut = new ArrayList<>();
    private final AcousticModel acoustics;
    private final MaterialMotion motion;
    private final Optional<SonatedLesion> lesion;
    private final LineCrossings[] crossings = new LineCrossings[LineWalk.LEVELS.length];
    private final float[] levels = new float[SectorGrid.LINES * SectorGrid.SAMPLES];
    private Depth depth;

    /** What depends on the depth of the image alone. */
    private static final class Depth {
        private final SectorGrid grid;
        private final SectorRaster raster;
        private final PointSpread spread;
        private final EchoField field;

        Depth(CurvilinearProbe probe, double depthMm) {
            grid = new SectorGrid(probe, depthMm);
            raster = new SectorRaster(grid, BModeImage.SIZE);
            spread = new PointSpread(grid);
            field = new EchoField(grid);
        }
    }

    /**
     * @param surfaces surfaces of a scene, in the order of its frames
     * @param threads number of threads
     */
    public Ultrasound(List<Surface> surfaces, CurvilinearProbe probe, int threads) {
        this(surfaces, probe, threads, Optional.empty());
    }

    /**
     * @param surfaces surfaces of a scene, in the order of its frames
     * @param threads number of threads
     * @param target lesion that is in the liver besides
     */
    public Ultrasound(List<Surface> surfaces, CurvilinearProbe probe, int threads, Optional<TargetLesion> target) {
        this.probe = probe;
        this.threads = threads;
        for (Surface surface : surfaces) {
            SonatedSurface sonated = new SonatedSurface(this.surfaces.size(), surface);
            this.surfaces.add(sonated);
            if (!sonated.isSeen() && surface.kind() != StructureKind.PLEURA) {
                leftOut.add(surface.name());
            }
        }
        lesion = target.map(t -> new SonatedLesion(this.surfaces.size(), t, indexOf(surfaces, StructureKind.LIVER)));
        lesion.ifPresent(this.surfaces::add);
        acoustics = new AcousticModel(probe.frequencyMhz());
        motion = new MaterialMotion(this.surfaces);
        for (int i = 0; i < crossings.length; i++) {
            crossings[i] = new LineCrossings();
        }
    }

    private static int indexOf(List<Surface> surfaces, StructureKind kind) {
        return IntStream.range(0, surfaces.size())
                .filter(i -> surfaces.get(i).kind() == kind)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("found no " + kind + ", expected one"));
    }

    private static float[] logarithms() {
        float[] table = new float[1 << LOG_BITS];
        for (int i = 0; i < table.length; i++) {
            table[i] = (float) (StrictMath.log(1 + (i + 0.5) / table.length) / StrictMath.log(2));
        }
        return table;
    }

    /**
     * Names of surfaces that are so open that they have no inside and are not seen. The diaphragm always is; the
     * pleura, which is never, is not among them.
     */
    public List<String> leftOut() {
        return List.copyOf(leftOut);
    }

    /**
     * Takes an image.
     *
     * @param frame positions of the surfaces
     * @param needle a needle, which may lie in the beam
     */
    public BModeImage take(Frame frame, ProbePose pose, UltrasoundSettings settings, Optional<SonatedNeedle> needle) {
        return take(frame, pose, settings, needle, lesion.map(SonatedLesion::restCentre));
    }

    /**
     * Takes an image.
     *
     * @param frame positions of the surfaces
     * @param needle a needle, which may lie in the beam
     * @param centre centre of the lesion in the frame, LPS, mm
     */
    public BModeImage take(
            Frame frame,
            ProbePose pose,
            UltrasoundSettings settings,
            Optional<SonatedNeedle> needle,
            Optional<double[]> centre) {
        lesion.ifPresent(l -> l.moveTo(centre.orElseGet(l::restCentre)));
        if (depth == null || depth.grid.depthMm != settings.depthMm()) {
            depth = new Depth(probe, settings.depthMm());
        }
        SectorGrid grid = depth.grid;
        Bands.run(surfaces.size(), threads, (from, to) -> {
            for (int i = from; i < to; i++) {
                surfaces.get(i).update(frame, pose, grid);
            }
        });
        motion.update(frame, pose, grid, threads);
        Bands.run(crossings.length, threads, (from, to) -> {
            for (int i = from; i < to; i++) {
                cut(i);
            }
        });
        EchoField field = depth.field;
        Bands.run(SectorGrid.LINES, threads, (from, to) -> {
            LineWalk walk = new LineWalk(surfaces, grid, acoustics, motion, pose, field);
            for (int line = from; line < to; line++) {
                walk.compute(line, crossings);
            }
        });
        needle.ifPresent(n -> n.addTo(field, grid, pose));
        float[] intensity = new float[levels.length];
        depth.spread.apply(field, intensity, threads);
        compress(intensity, settings);
        return new BModeImage(pose, settings, grid, depth.raster, intensity, depth.raster.convert(levels, threads));
    }

    private void cut(int level) {
        crossings[level].clear();
        surfaces.stream()
                .filter(SonatedSurface::isSeen)
                .forEach(s -> s.crossings(depth.grid, LineWalk.LEVELS[level], crossings[level]));
    }

    /** Levels of 0 to 255, linear in the logarithm of the compensated intensity. */
    private void compress(float[] intensity, UltrasoundSettings settings) {
        double dbPerLog2 = 10 * StrictMath.log10(2);
        double levelPerDb = 255 / settings.dynamicRangeDb();
        float scale = (float) (levelPerDb * dbPerLog2);
        Bands.run(SectorGrid.LINES, threads, (from, to) -> {
            for (int s = 0; s < SectorGrid.SAMPLES; s++) {
                double depthMm = s * depth.grid.stepMm;
                double compensation = Math.min(
                        MAX_DEPTH_GAIN_DB, settings.depthGainDbPerCmMhz() * probe.frequencyMhz() * 2 * depthMm / 10);
                float offset = (float) (255 + levelPerDb * (compensation + settings.gainDb() - WHITE_DB));
                for (int i = from * SectorGrid.SAMPLES + s; i < to * SectorGrid.SAMPLES; i += SectorGrid.SAMPLES) {
                    levels[i] = Math.max(0, Math.min(255, offset + scale * log2(intensity[i])));
                }
            }
        });
    }

    /** Logarithm of a number that is not negative, within 0.0002; very low for zero. */
    private static float log2(float value) {
        int bits = Float.floatToRawIntBits(value);
        return (bits >>> 23) - 127 + LOG2[(bits & 0x7fffff) >>> (23 - LOG_BITS)];
    }
}
