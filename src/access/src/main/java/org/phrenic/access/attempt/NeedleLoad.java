package org.phrenic.access.attempt;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import org.phrenic.access.Needle;
import org.phrenic.access.path.Crossing;
import org.phrenic.anatomy.StructureKind;

/**
 * Loads on a needle at one moment: readouts, which move nothing. Forces are those of a needle of 18 G and grow with the
 * diameter.
 *
 * <p>Axial force of a needle that advances: {@code F = c + f d + P (u / s)²}, with the cutting force c of the tissue at
 * the tip, the friction f on its length d in the body, and, while a membrane (skin, pleura, capsule) is pushed by u
 * before it is cut at u = s, the force of the puncture P. Okamura et al. 2004 (doi 10.1109/TBME.2004.831542) split the
 * force in excised bovine liver into such parts. In liver c is 0.94 N; this and all other values are chosen, not
 * measured. The capsule is pushed by 3.5 mm, in proportion to the diameter: 2.0 mm at 22 G, 6.1 mm at 14 G.
 *
 * <p>Side load, while the tip is in the liver and the puncture in the capsule lies p beside the needle's line: the
 * needle is a beam that is held at the skin, stiffness {@code k = 3 E I / L³} at the capsule at a depth L, in series
 * with the tissue, {@value #TISSUE_N_PER_MM} N/mm: the force is {@code p k t / (k + t)}, and it bends the needle by
 * force over k. E is 193 GPa (steel 304), I that of a solid rod, for the stylet is in.
 *
 * @param layer what the tip cuts or pushes; empty if the needle does not advance
 * @param axialN axial force, N; 0 if the needle does not advance
 * @param capsulePushMm how far the capsule is pushed, mm
 * @param sideN side load at the capsule, N
 * @param bendingMm how far it bends the needle there, mm
 * @param inLiver whether the tip is in the liver
 */
public record NeedleLoad(
        String layer, double axialN, double capsulePushMm, double sideN, double bendingMm, boolean inLiver) {
    /** No load. */
    public static final NeedleLoad NONE = new NeedleLoad("", 0, 0, 0, 0, false);

    /** Layers, in the order in which a needle meets them. */
    static final List<String> LAYERS = List.of("skin", "wall", "pleura", "capsule", "liver");

    private static final Membrane SKIN = new Membrane("skin", 3.0, 3.0);
    private static final Membrane PLEURA = new Membrane("pleura", 1.0, 1.5);
    private static final Membrane CAPSULE = new Membrane("capsule", 1.5, 3.5);
    private static final double WALL_N = 0.8;
    private static final double LIVER_N = 0.94;
    private static final double FRICTION_N_PER_MM = 0.01;
    private static final double REFERENCE_RADIUS_MM = 0.6;
    /** Depths along the needle are known to this, mm. */
    private static final double TOLERANCE_MM = 1e-9;

    private static final double STEEL_MPA = 193_000;
    private static final double TISSUE_N_PER_MM = 0.5;

    /** A layer that is pushed before it is cut, by a needle of 18 G. */
    private record Membrane(String name, double peakN, double pushMm) {
        /** Force on a needle whose tip came from one depth to another, the membrane at rest at a depth. */
        double forceN(double restMm, double fromMm, double toMm, double push) {
            if (toMm <= restMm || fromMm >= restMm + push) {
                return 0;
            }
            double u = Math.min(1, (toMm - restMm) / push);
            return peakN * u * u;
        }
    }

    /** A membrane, and the depth at which it rests, mm; infinite if there is none. */
    private record Resting(Membrane membrane, double restMm) {}

    /** How far a needle pushes the capsule of the liver before it is cut, mm. */
    static double capsulePushMm(Needle needle) {
        return CAPSULE.pushMm * scale(needle);
    }

    private static double scale(Needle needle) {
        return needle.radiusMm() / REFERENCE_RADIUS_MM;
    }

    /**
     * Load on a needle that has advanced. A part of the liver that the tip has left is not pushed.
     *
     * @param crossings what the needle crosses at its new depth
     * @param inLiver whether the capsule is cut
     */
    static NeedleLoad advancing(
            Needle needle, double fromMm, double toMm, List<Crossing> crossings, boolean inLiver, NeedleLoad side) {
        double scale = scale(needle);
        List<Resting> membranes =
                new ArrayList<>(List.of(new Resting(SKIN, 0), new Resting(PLEURA, recess(crossings))));
        capsules(crossings, fromMm).forEach(restMm -> membranes.add(new Resting(CAPSULE, restMm)));
        String layer = inLiver ? "liver" : "wall";
        double push = 0;
        for (Resting m : membranes) {
            double force = m.membrane.forceN(m.restMm, fromMm, toMm, m.membrane.pushMm * scale);
            layer = force > 0 ? m.membrane.name : layer;
            push = Math.max(push, force);
        }
        double cutting = inLiver ? LIVER_N : WALL_N;
        double axial = scale * (cutting + FRICTION_N_PER_MM * toMm + push);
        double capsule = capsules(crossings, toMm).min().orElse(Double.POSITIVE_INFINITY);
        double pushed = inLiver ? 0 : Math.max(0, toMm - capsule);
        return new NeedleLoad(layer, axial, pushed, side.sideN, side.bendingMm, inLiver);
    }

    /** Side load of a needle whose puncture in the capsule lies beside its line. */
    static NeedleLoad aside(Needle needle, double pullMm, double capsuleDepthMm) {
        double d = 2 * needle.radiusMm();
        double inertia = Math.PI * d * d * d * d / 64;
        double length = Math.max(1, capsuleDepthMm);
        double k = 3 * STEEL_MPA * inertia / (length * length * length);
        double force = pullMm * k * TISSUE_N_PER_MM / (k + TISSUE_N_PER_MM);
        return new NeedleLoad("", 0, 0, force, force / k, true);
    }

    /** Depths of the capsules of the parts of the liver that hold a tip or lie beyond it, mm. */
    private static DoubleStream capsules(List<Crossing> crossings, double tipMm) {
        return crossings.stream()
                .filter(c -> c.kind() == StructureKind.LIVER && c.toMm() >= tipMm - TOLERANCE_MM)
                .mapToDouble(Crossing::fromMm);
    }

    private static double recess(List<Crossing> crossings) {
        return crossings.stream()
                .filter(c -> c.name().equals(Crossing.RECESS))
                .mapToDouble(Crossing::fromMm)
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }
}
