package org.phrenic.access.ultrasound;

import java.util.Arrays;
import java.util.List;
import org.phrenic.access.imaging.Tissue;
import org.phrenic.anatomy.StructureKind;

/**
 * Follows the pulse along scan lines through the tissues: attenuation {@code 10^(-a f 2 d / 20)} of the amplitude,
 * echoes of scatterers and of interfaces, and {@code 1 - r^2} on the way there and back through an interface. Before
 * the skin there is gel, behind it gas. One walk is used by one thread.
 */
final class LineWalk {
    /** Levels of the elevation in units of the beam's width. */
    static final double[] LEVELS = {-2 / 3.0, -1 / 3.0, 0, 1 / 3.0, 2 / 3.0};
    /** The beam's profile at the levels, of sum 1. */
    private static final double[] WEIGHTS = {1 / 12.0, 3 / 12.0, 4 / 12.0, 3 / 12.0, 1 / 12.0};

    private static final int CENTRAL = 2;
    /** Interfaces nearer to each other than this are one, mm. */
    private static final double SAME_DEPTH_MM = 1e-6;
    /** Amplitude below which a line is over. */
    private static final double SILENCE = 1e-7;
    /** Amplitude reflected by the face of the transducer. */
    private static final double FACE_REFLECTION = 0.15;
    /** A reflector as strong as this sends echoes back and forth. */
    private static final double STRONG = 0.5;
    /** Largest range of depths of an interface within one of the levels, mm. */
    private static final double MAX_EXTENT_MM = 8;

    private final List<SonatedSurface> surfaces;
    private final SectorGrid grid;
    private final AcousticModel acoustics;
    private final MaterialMotion motion;
    private final EchoField field;
    private final SpeckleField speckle = new SpeckleField();
    private final int[] inside;
    private boolean entered;
    private int line;
    private int level;
    private double strongDepth;
    private double strongFactor;
    private final double[] from = new double[3];
    private final double[] to = new double[3];
    private final double[][] axes;
    private final double[] face;

    LineWalk(
            List<SonatedSurface> surfaces,
            SectorGrid grid,
            AcousticModel acoustics,
            MaterialMotion motion,
            ProbePose pose,
            EchoField field) {
        this.surfaces = surfaces;
        this.grid = grid;
        this.acoustics = acoustics;
        this.motion = motion;
        this.field = field;
        axes = new double[][] {pose.lateral(), pose.axial(), pose.elevation()};
        face = pose.face();
        inside = new int[surfaces.size()];
    }

    /** Computes the echoes of a line from its crossings at all levels. */
    void compute(int scanLine, LineCrossings[] crossings) {
        line = scanLine;
        field.clear(line);
        strongFactor = 0;
        for (level = 0; level < LEVELS.length; level++) {
            walk(crossings[level]);
        }
        if (strongFactor > 0) {
            field.reverberate(line, strongDepth, strongFactor);
        }
    }

    private void walk(LineCrossings crossings) {
        Arrays.fill(inside, 0);
        entered = false;
        int count = crossings.count(line);
        int k = 0;
        while (k < count && crossings.depth(line, k) < 0) {
            pass(crossings.code(line, k++));
        }
        int now = top();
        double depth = 0;
        double amplitude = 1;
        while (depth < grid.depthMm && amplitude > SILENCE) {
            double next = k < count ? Math.min(crossings.depth(line, k), grid.depthMm) : grid.depthMm;
            Tissue tissue = tissue(now);
            scatter(now, tissue, depth, next, amplitude);
            amplitude *= StrictMath.exp(-acoustics.nepersPerMm(tissue) * (next - depth));
            depth = next;
            int first = k;
            boolean sheet = false;
            boolean portal = false;
            while (k < count && crossings.depth(line, k) <= depth + SAME_DEPTH_MM) {
                sheet |= isSheet(crossings.code(line, k));
                portal |= isPortal(crossings.code(line, k));
                pass(crossings.code(line, k++));
            }
            if (k > first) {
                int then = top();
                Tissue behind = tissue(then);
                boolean inLiver = tissue == Tissue.LIVER || behind == Tissue.LIVER;
                double r = acoustics.reflection(tissue, behind, sheet || (portal && inLiver));
                echo(crossings, first, amplitude, r, behind);
                amplitude *= 1 - r * r;
                now = then;
            }
        }
    }

    /** Whether a crossing is one with the diaphragm, open or closed. */
    private boolean isSheet(int code) {
        return code == 0 || surfaces.get(Math.abs(code) - 1).surface.kind() == StructureKind.DIAPHRAGM;
    }

    private boolean isPortal(int code) {
        return code != 0 && surfaces.get(Math.abs(code) - 1).portal;
    }

    private void pass(int code) {
        if (code != 0) {
            int surface = Math.abs(code) - 1;
            inside[surface] += Integer.signum(code);
            entered |= code > 0 && surfaces.get(surface).surface.kind() == StructureKind.SKIN;
        }
    }

    /** Index of the surface whose tissue is here; negative outside of all. */
    private int top() {
        int best = -1;
        for (int i = 0; i < inside.length; i++) {
            if (inside[i] > 0 && (best < 0 || surfaces.get(i).rank > surfaces.get(best).rank)) {
                best = i;
            }
        }
        return best;
    }

    private Tissue tissue(int surface) {
        if (surface < 0) {
            return entered ? Tissue.GAS : Tissue.WATER;
        }
        return surfaces.get(surface).tissue;
    }

    private void echo(LineCrossings crossings, int k, double amplitude, double reflection, Tissue behind) {
        double returned = reflection * AcousticModel.specular(crossings.cosine(line, k));
        double depth = crossings.depth(line, k);
        double stripMm = grid.probe.elevationWidthMm(depth) / 3;
        double extent = Math.min(MAX_EXTENT_MM, stripMm * crossings.slope(line, k));
        field.addEcho(line, depth, WEIGHTS[level] * amplitude * returned, extent);
        boolean gas = behind == Tissue.LUNG || behind == Tissue.GAS;
        if (gas && level == CENTRAL && returned > STRONG && strongFactor == 0) {
            strongDepth = depth;
            strongFactor = FACE_REFLECTION * amplitude * returned;
        }
    }

    /** Adds the scatterers of one tissue between two depths. */
    private void scatter(int surface, Tissue tissue, double fromMm, double toMm, double amplitude) {
        int first = (int) Math.ceil(fromMm / grid.stepMm);
        int end = Math.min(SectorGrid.SAMPLES, (int) Math.ceil(toMm / grid.stepMm));
        if (toMm >= grid.depthMm) {
            end = SectorGrid.SAMPLES;
        }
        double nepers = acoustics.nepersPerMm(tissue);
        double perSample = StrictMath.exp(-nepers * grid.stepMm);
        double here = amplitude * StrictMath.exp(-nepers * (first * grid.stepMm - fromMm));
        double strength = Math.sqrt(WEIGHTS[level]) * acoustics.backscatter(tissue);
        int at = first;
        while (at < end && here > SILENCE) {
            int node = at / MaterialMotion.SAMPLE_STEP;
            int stop = Math.min(end, (node + 1) * MaterialMotion.SAMPLE_STEP);
            material(surface, node, from);
            material(surface, node + 1, to);
            here = scatterBlock(at, stop, here, perSample, strength);
            at = stop;
        }
    }

    /** Rest coordinates of a node of the line, in cells of the speckle. */
    private void material(int surface, int node, double[] out) {
        double depth = node * MaterialMotion.SAMPLE_STEP * grid.stepMm;
        if (surface >= 0) {
            motion.at(surfaces.get(surface).carrier(), line, node, out);
        } else {
            Arrays.fill(out, 0);
        }
        double range = grid.probe.radiusMm() + depth;
        double x = range * grid.sin[line];
        double z = range * grid.cos[line] - grid.probe.radiusMm();
        double y = LEVELS[level] * grid.probe.elevationWidthMm(depth);
        for (int axis = 0; axis < 3; axis++) {
            double place = face[axis] + x * axes[0][axis] + z * axes[1][axis] + y * axes[2][axis] + out[axis];
            out[axis] = place / SpeckleField.CELL_MM + SpeckleField.OFFSET;
        }
    }

    /** Adds samples between two nodes; returns the amplitude at the last sample and one step further. */
    private double scatterBlock(int first, int end, double amplitude, double perSample, double strength) {
        int step = MaterialMotion.SAMPLE_STEP;
        double dx = (to[0] - from[0]) / step;
        double dy = (to[1] - from[1]) / step;
        double dz = (to[2] - from[2]) / step;
        int skip = first % step;
        double x = from[0] + skip * dx;
        double y = from[1] + skip * dy;
        double z = from[2] + skip * dz;
        int row = line * SectorGrid.SAMPLES;
        double here = amplitude;
        float[] re = field.real;
        float[] im = field.imaginary;
        for (int s = row + first; s < row + end; s++) {
            speckle.lookUp(x, y, z);
            float a = (float) (here * strength);
            re[s] += a * speckle.real();
            im[s] += a * speckle.imaginary();
            if (level == CENTRAL) {
                field.kept[s] = (float) here;
            }
            x += dx;
            y += dy;
            z += dz;
            here *= perSample;
        }
        return here;
    }
}
