package org.phrenic.access.ultrasound;

import org.phrenic.access.Needle;
import org.phrenic.mesh.Vectors;

/**
 * A needle in the beam of an ultrasound probe. Its echo has the amplitude {@code r cos^(n/2)(angle of incidence) p D /
 * w}: r of steel in soft tissue, p the beam's profile at the needle's elevation and D / w the share of the beam's
 * thickness that its diameter covers. It is brightest at a right angle to the beam and none where the beam does not
 * reach. The bevel of the tip scatters in all directions.
 *
 * @param entry where the needle enters the skin, or a point of the shaft farther out, LPS, mm
 * @param tip LPS, mm
 * @param needle gives the diameter
 */
public record SonatedNeedle(double[] entry, double[] tip, Needle needle) {
    /** Of steel, 46 MRayl, in soft tissue, 1.6 MRayl. */
    private static final double REFLECTION = 0.93;
    /** Amplitude of the tip's echo relative to that of the shaft at a right angle. */
    private static final double TIP = 0.5;

    private static final double STEP_MM = 0.25;

    /** Length of the needle, mm, within half of the beam's thickness of the image plane, sector and depth. */
    public double lengthInBeamMm(CurvilinearProbe probe, ProbePose pose, double depthMm) {
        double length = Vectors.length(Vectors.subtract(tip, entry));
        int steps = Math.max(1, (int) Math.ceil(length / STEP_MM));
        int seen = 0;
        for (int i = 0; i < steps; i++) {
            seen += isInBeam(Vectors.lerp(entry, tip, (i + 0.5) / steps), probe, pose, depthMm) ? 1 : 0;
        }
        return length * seen / steps;
    }

    /** Whether the tip is within half of the beam's thickness of the image plane, sector and depth. */
    public boolean isTipInBeam(CurvilinearProbe probe, ProbePose pose, double depthMm) {
        return isInBeam(tip, probe, pose, depthMm);
    }

    /** Whether a point is within half of the beam's thickness of the image plane, sector and depth. */
    static boolean isInBeam(double[] point, CurvilinearProbe probe, ProbePose pose, double depthMm) {
        double[] p = pose.toProbe(point);
        double z = p[1] + probe.radiusMm();
        double depth = Math.sqrt(p[0] * p[0] + z * z) - probe.radiusMm();
        double edge = StrictMath.tan(StrictMath.toRadians(0.5 * probe.sectorDeg()));
        return depth >= 0
                && depth <= depthMm
                && Math.abs(p[0]) <= z * edge
                && Math.abs(p[2]) <= 0.5 * probe.elevationWidthMm(depth);
    }

    /** Adds the echoes to those of the tissues. */
    void addTo(EchoField field, SectorGrid grid, ProbePose pose) {
        double[] a = pose.toProbe(entry);
        double[] b = pose.toProbe(tip);
        double radius = grid.probe.radiusMm();
        a[1] += radius;
        b[1] += radius;
        double[] along = Vectors.normalize(Vectors.subtract(b, a));
        for (int line = 0; line < SectorGrid.LINES; line++) {
            double sa = grid.side(line, a[0], a[1]);
            double sb = grid.side(line, b[0], b[1]);
            if (sa < 0 != sb < 0) {
                double[] p = Vectors.lerp(a, b, sa / (sa - sb));
                double cosine = along[0] * grid.sin[line] + along[1] * grid.cos[line];
                double sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
                addEcho(field, grid, line, p, AcousticModel.specular(sine));
            }
        }
        double line = grid.lineAt(b[0], b[1]);
        if (line >= 0 && line <= SectorGrid.LINES - 1) {
            addEcho(field, grid, (int) Math.round(line), b, TIP);
        }
    }

    private void addEcho(EchoField field, SectorGrid grid, int line, double[] p, double factor) {
        double depth = p[0] * grid.sin[line] + p[1] * grid.cos[line] - grid.probe.radiusMm();
        if (depth < 0 || depth > grid.depthMm) {
            return;
        }
        double share = 2 * needle.radiusMm() / grid.probe.elevationWidthMm(depth);
        double kept = field.kept[line * SectorGrid.SAMPLES + (int) Math.round(depth / grid.stepMm)];
        double profile = grid.probe.elevationProfile(p[2], depth);
        field.addEcho(line, depth, REFLECTION * factor * profile * share * kept, 0);
    }
}
