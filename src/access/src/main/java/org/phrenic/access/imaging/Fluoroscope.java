package org.phrenic.access.imaging;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Takes radiographs of the moving body by the Beer-Lambert law: {@code I / I0 = exp(-sum_s mu_s L_s)} along the ray of
 * each pixel, at one photon energy, without scatter and noise. {@code L_s} is the length of the ray inside the closed
 * surface s, mm, {@code mu_s} its linear attenuation coefficient, 1/mm.
 *
 * <p>The skin encloses soft tissue. A structure within it replaces soft tissue, and a lesion replaces liver, so it
 * counts with the difference of the coefficients. The lungs keep their mass: their coefficient goes with one over their
 * volume. Holes are closed ({@link CappedSurface}); an open sheet has no inside and is left out.
 */
public final class Fluoroscope {
    /** Photon energy of a beam of 80 to 90 kV, about, keV. */
    public static final double ENERGY_KEV = 60;

    /** Area vector over area from which a surface has no inside; 0 if it is closed, 1 for a flat sheet. */
    private static final double MOST_OPEN = 0.2;

    private record Part(int index, Surface surface, CappedSurface capped, double orientation, double restVolume) {}

    private final List<Surface> surfaces;
    private final List<Part> parts = new ArrayList<>();
    private final List<String> leftOut = new ArrayList<>();
    private final boolean skin;
    private final int threads;

    /**
     * @param surfaces surfaces of a scene, in the order of its frames
     * @param threads number of threads; the bits of radiographs do not depend on it
     */
    public Fluoroscope(List<Surface> surfaces, int threads) {
        this.surfaces = List.copyOf(surfaces);
        this.threads = threads;
        for (int i = 0; i < surfaces.size(); i++) {
            Surface surface = surfaces.get(i);
            if (openness(surface.rest()) < MOST_OPEN) {
                CappedSurface capped = new CappedSurface(surface.rest());
                double volume =
                        MeshMeasure.signedVolume(capped.at(surface.rest().positions()));
                parts.add(new Part(i, surface, capped, Math.signum(volume), Math.abs(volume)));
            } else {
                leftOut.add(surface.name());
            }
        }
        skin = parts.stream().anyMatch(part -> part.surface().kind() == StructureKind.SKIN);
    }

    /** Length of the sum of the area vectors over the area. */
    private static double openness(TriangleMesh mesh) {
        double[] sum = new double[3];
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double[] a = areaVector(mesh, t);
            sum = Vectors.addScaled(sum, a, 1);
        }
        return Vectors.length(sum) / MeshMeasure.area(mesh);
    }

    private static double[] areaVector(TriangleMesh mesh, int triangle) {
        double[][] corner = new double[3][];
        for (int k = 0; k < 3; k++) {
            int v = mesh.triangles()[3 * triangle + k];
            corner[k] = Vectors.of(mesh.x(v), mesh.y(v), mesh.z(v));
        }
        double[] cross = Vectors.cross(Vectors.subtract(corner[1], corner[0]), Vectors.subtract(corner[2], corner[0]));
        return Vectors.addScaled(new double[3], cross, 0.5);
    }

    /** Names of surfaces that are not closed. */
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
        PathLengths lengths = new PathLengths(arm, threads);
        for (Part part : parts) {
            Surface surface = surfaces.get(part.index());
            double[] p = new double[surface.rest().positions().length];
            frame.writePositions(surface, part.index(), p);
            TriangleMesh mesh = part.capped().at(p);
            lengths.add(mesh, part.orientation() * coefficient(part, mesh, energyKev));
        }
        return new Radiograph(arm, lengths.values());
    }

    /** What a millimetre of a structure adds to its surroundings, 1/mm. */
    private double coefficient(Part part, TriangleMesh now, double energyKev) {
        double own = Tissue.of(part.surface()).attenuationPerMm(energyKev);
        return switch (part.surface().kind()) {
            case SKIN -> own;
            case LESION -> own - Tissue.LIVER.attenuationPerMm(energyKev);
            case LUNG -> own * part.restVolume() / Math.abs(MeshMeasure.signedVolume(now)) - surroundings(energyKev);
            default -> own - surroundings(energyKev);
        };
    }

    private double surroundings(double energyKev) {
        return skin ? Tissue.SOFT.attenuationPerMm(energyKev) : 0;
    }
}
