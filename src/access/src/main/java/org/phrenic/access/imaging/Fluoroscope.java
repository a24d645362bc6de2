package org.phrenic.access.imaging;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.CappedSurface;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Takes radiographs of the moving body by the Beer-Lambert law: {@code I / I0 = exp(-sum_s mu_s L_s)} along the ray of
 * each pixel, at one photon energy, without scatter and noise. {@code L_s} is the length of the ray inside the closed
 * surface s, mm, {@code mu_s} its linear attenuation coefficient, 1/mm.
 *
 * <p>The skin encloses soft tissue. A structure within it replaces soft tissue, or the lung or liver that it lies in
 * ({@link EnclosingOrgans}), so it counts with the difference of the coefficients. The lungs keep their mass: their
 * coefficient goes with one over their volume. Holes are closed ({@link CappedSurface}); an open sheet has no inside
 * and is left out.
 */
public final class Fluoroscope {
    /** Photon energy of a beam of 80 to 90 kV, about, keV. */
    public static final double ENERGY_KEV = 60;

    private record Part(int index, Surface surface, CappedSurface capped, double orientation, double restVolume) {
        boolean mayEnclose() {
            return surface.kind() == StructureKind.LUNG || surface.kind() == StructureKind.LIVER;
        }

        boolean mayBeEnclosed() {
            return switch (surface.kind()) {
                case VESSEL, LESION, ORGAN, OTHER -> true;
                default -> false;
            };
        }

        TriangleMesh rest() {
            return capped.at(surface.rest().positions());
        }
    }

    private final List<Part> parts = new ArrayList<>();
    private final List<String> leftOut = new ArrayList<>();
    /** Indices of the parts that are lungs and liver. */
    private final int[] organs;
    /** Shares of each part in each of the organs. */
    private final List<double[]> shares = new ArrayList<>();

    private final boolean skin;
    private final int threads;

    /**
     * @param surfaces surfaces of a scene, in the order of its frames
     * @param threads number of threads; the bits of radiographs do not depend on it
     */
    public Fluoroscope(List<Surface> surfaces, int threads) {
        this.threads = threads;
        for (int i = 0; i < surfaces.size(); i++) {
            Surface surface = surfaces.get(i);
            if (surface.kind() == StructureKind.PLEURA) {
                continue;
            }
            if (MeshMeasure.hasInside(surface.rest())) {
                CappedSurface capped = new CappedSurface(surface.rest());
                double volume =
                        MeshMeasure.signedVolume(capped.at(surface.rest().positions()));
                parts.add(new Part(i, surface, capped, Math.signum(volume), Math.abs(volume)));
            } else {
                leftOut.add(surface.name());
            }
        }
        skin = parts.stream().anyMatch(part -> part.surface().kind() == StructureKind.SKIN);
        organs = IntStream.range(0, parts.size())
                .filter(i -> parts.get(i).mayEnclose())
                .toArray();
        EnclosingOrgans enclosing = new EnclosingOrgans(
                IntStream.of(organs).mapToObj(i -> parts.get(i).rest()).toList());
        for (Part part : parts) {
            shares.add(part.mayBeEnclosed() ? enclosing.sharesOf(part.surface().rest()) : new double[organs.length]);
        }
    }

    /** Names of surfaces without an inside, but for the pleura. */
    public List<String> leftOut() {
        return List.copyOf(leftOut);
    }

    /**
     * Takes a radiograph.
     *
     * @param frame positions of the surfaces
     * @param energyKev photon energy, 40 to 80 keV
     */
    public Radiograph take(Frame frame, CArm arm, double energyKev) {
        return take(frame, arm, energyKev, List.of());
    }

    /**
     * Takes a radiograph with needles in it.
     *
     * @param frame positions of the surfaces
     * @param energyKev photon energy, 40 to 80 keV
     * @param steel needles; what they add to soft tissue counts along their whole length
     */
    public Radiograph take(Frame frame, CArm arm, double energyKev, List<SteelRod> steel) {
        PathLengths lengths = new PathLengths(arm, threads);
        List<TriangleMesh> meshes = parts.stream().map(part -> now(part, frame)).toList();
        double[] perMm = new double[parts.size()];
        Arrays.setAll(perMm, i -> coefficient(parts.get(i), meshes.get(i), energyKev));
        for (int i = 0; i < perMm.length; i++) {
            Part part = parts.get(i);
            double around = surroundings(part, shares.get(i), perMm, energyKev);
            lengths.add(meshes.get(i), part.orientation() * (perMm[i] - around));
        }
        for (SteelRod rod : steel) {
            lengths.add(rod.mesh(), SteelRod.attenuationPerMm(energyKev) - surroundings(energyKev));
        }
        return new Radiograph(arm, lengths.values());
    }

    /** The closed surface of a part in a frame. */
    private static TriangleMesh now(Part part, Frame frame) {
        double[] p = new double[part.surface().rest().positions().length];
        frame.writePositions(part.surface(), part.index(), p);
        return part.capped().at(p);
    }

    /** Linear attenuation coefficient of a structure, 1/mm. */
    private static double coefficient(Part part, TriangleMesh now, double energyKev) {
        double own = Tissue.of(part.surface()).attenuationPerMm(energyKev);
        return part.surface().kind() == StructureKind.LUNG
                ? own * part.restVolume() / Math.abs(MeshMeasure.signedVolume(now))
                : own;
    }

    /** Coefficient of what a structure replaces, 1/mm. */
    private double surroundings(Part part, double[] shares, double[] perMm, double energyKev) {
        if (part.surface().kind() == StructureKind.SKIN) {
            return 0;
        }
        double mean = 0;
        double enclosed = 0;
        for (int i = 0; i < shares.length; i++) {
            mean += shares[i] * perMm[organs[i]];
            enclosed += shares[i];
        }
        return enclosed > 0 ? mean : surroundings(energyKev);
    }

    private double surroundings(double energyKev) {
        return skin ? Tissue.SOFT.attenuationPerMm(energyKev) : 0;
    }
}
