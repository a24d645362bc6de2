package org.phrenic.anatomy.virtual;

import org.phrenic.anatomy.virtual.shape.Meridians;
import org.phrenic.anatomy.virtual.shape.RingMesh;
import org.phrenic.anatomy.virtual.shape.RootFinder;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.anatomy.virtual.shape.SurfaceRelaxation;
import org.phrenic.anatomy.virtual.shape.TwoFacedSheet;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * The diaphragm as a closed sheet with two faces: its middle surface offset by half the thickness to either side. Of n
 * vertices, vertex i lies on the thoracic face and vertex i + n/2 is its partner on the abdominal face. The rim
 * vertices are the last of each half.
 */
final class DiaphragmSheet {
    private static final double PIVOT_Z = 20;
    private static final int SWEEPS = 20;
    private static final double CRURA_HALF_BREADTH_MM = 60;
    private static final double TENDON_EDGE_MM = 8;

    private final VirtualThoraxParameters.Diaphragm measures;
    private final DiaphragmShape shape;
    private final Meridians meridians;

    DiaphragmSheet(VirtualThoraxParameters.Diaphragm measures, DiaphragmShape shape, ChestWallShape wall) {
        this.measures = measures;
        this.shape = shape;
        double[][] border = new double[Meridians.AZIMUTHS][];
        for (int i = 0; i < border.length; i++) {
            double azimuth = Meridians.azimuth(i);
            double z = shape.rimZ(azimuth > Math.PI ? azimuth - 2 * Math.PI : azimuth);
            double r = RootFinder.firstOutward(s -> shape.at(wall.point(azimuth, s, z)), 50);
            border[i] = wall.point(azimuth, r, z);
        }
        meridians = new Meridians(shape, wall, PIVOT_Z, true, border);
    }

    TriangleMesh mesh(int vertices) {
        double edge = RingMesh.edgeLengthFor(e -> RingMesh.vertexCount(RingMesh.counts(meridians, e, 0)), vertices / 2);
        int[] counts = RingMesh.counts(meridians, edge, 0);
        int inner = RingMesh.vertexCount(counts) - counts[counts.length - 1];
        TriangleMesh middle = RingMesh.mesh(meridians, counts, true);
        middle = SurfaceRelaxation.relaxAndLengthen(middle, SWEEPS, v -> v < inner ? shape : null);
        return thicken(softenCrura(middle, inner), inner);
    }

    /**
     * Smooths sharp edges near the crura, where the sheet bends more than its thickness allows. Edges farther lateral
     * stay, because the liver lies close to them.
     */
    private TriangleMesh softenCrura(TriangleMesh middle, int firstRim) {
        int n = middle.vertexCount();
        int[] face = middle.triangles();
        double[][] p = new double[n][];
        double[][] normals = new double[n][];
        for (int v = 0; v < n; v++) {
            p[v] = Vectors.of(middle.x(v), middle.y(v), middle.z(v));
            normals[v] = shape.normal(p[v]);
        }
        double edge = MeshQuality.of(middle).meanEdgeMm();
        double sharpCosine = StrictMath.cos(edge / measures.cruralRadiusMm());
        double[] share = new double[n];
        for (int c = 0; c < face.length; c++) {
            int a = face[c];
            int b = face[c % 3 == 2 ? c - 2 : c + 1];
            if (Math.abs(p[a][0]) < CRURA_HALF_BREADTH_MM && Vectors.dot(normals[a], normals[b]) < sharpCosine) {
                share[a] = a < firstRim ? 0.5 : 0;
                share[b] = b < firstRim ? 0.5 : 0;
            }
        }
        int passes = TwoFacedSheet.passesOver(measures.cruralSmoothingMm(), edge);
        for (int pass = 0; pass < passes; pass++) {
            double[][] sums = new double[n][3];
            int[] count = new int[n];
            for (int c = 0; c < face.length; c++) {
                int a = face[c];
                sums[a] = Vectors.addScaled(sums[a], p[face[c % 3 == 2 ? c - 2 : c + 1]], 1);
                count[a]++;
            }
            for (int v = 0; v < n; v++) {
                if (share[v] > 0) {
                    p[v] = Vectors.lerp(
                            p[v], Vectors.addScaled(Vectors.of(0, 0, 0), sums[v], 1.0 / count[v]), share[v]);
                }
            }
        }
        double[] positions = new double[3 * n];
        for (int v = 0; v < n; v++) {
            System.arraycopy(p[v], 0, positions, 3 * v, 3);
        }
        return middle.withPositions(positions);
    }

    private TriangleMesh thicken(TriangleMesh middle, int firstRim) {
        int n = middle.vertexCount();
        double[] normals = new double[3 * n];
        double[] thickness = new double[n];
        for (int v = 0; v < n; v++) {
            double[] p = Vectors.of(middle.x(v), middle.y(v), middle.z(v));
            System.arraycopy(shape.normal(p), 0, normals, 3 * v, 3);
            thickness[v] = thickness(p);
        }
        int[] rim = new int[2 * (n - firstRim)];
        for (int v = firstRim; v < n; v++) {
            rim[2 * (v - firstRim)] = v;
            rim[2 * (v - firstRim) + 1] = v + 1 < n ? v + 1 : firstRim;
        }
        return TwoFacedSheet.of(middle, normals, measures.normalSmoothingMm(), thickness, rim);
    }

    /**
     * Thickness, mm. It is smaller within the central tendon, a trefoil of about the given area around the domes and
     * the plateau.
     */
    private double thickness(double[] p) {
        double edge = tendonEdge(p[0], p[1], p[2]);
        return measures.muscleMm()
                + (measures.tendonMm() - measures.muscleMm()) * SmoothBlends.smoothstep(0.5 - edge / TENDON_EDGE_MM);
    }

    private double tendonEdge(double x, double y, double z) {
        if (z < Math.min(measures.left().at(2), measures.heart().at(2)) - 25) {
            return TENDON_EDGE_MM;
        }
        double radius = Math.sqrt(measures.tendonAreaCm2() * 100 / (3 * Math.PI)) * 0.92;
        double right = StrictMath.hypot(
                (x - measures.right().at(0) * 0.72) / 1.15,
                (y - measures.right().at(1) - 12) / 1.0);
        double left = StrictMath.hypot(
                (x - measures.left().at(0) * 0.72) / 1.1, (y - measures.left().at(1) - 12) / 0.85);
        double front = StrictMath.hypot(
                (x - measures.heart().at(0)) / 1.1, (y - measures.heart().at(1) + 4) / 0.95);
        return SmoothBlends.smoothUnion(SmoothBlends.smoothUnion(right, left, 20), front, 20) - radius;
    }
}
