package org.phrenic.anatomy.virtual;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.shape.RingMesh;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.anatomy.virtual.shape.Tube;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.TriangleMesh;

/** Meshes of the sternum and the costal cartilages with a given total number of vertices. */
final class SternumMeshes {
    private static final double CAP_MM = 2;
    private static final double SECTION_FLATNESS = 2.4;

    private record Cartilage(int level, Side side, Polyline course) {}

    private final VirtualThoraxParameters parameters;
    private final ChestWallShape wall;
    private final int vertices;
    private final List<Cartilage> cartilages = new ArrayList<>();

    SternumMeshes(VirtualThoraxParameters parameters, ChestWallShape wall, int vertices) {
        this.parameters = parameters;
        this.wall = wall;
        this.vertices = vertices;
    }

    void cartilage(int level, Side side, Polyline course) {
        cartilages.add(new Cartilage(level, side, course));
    }

    List<Structure> build(SternumShape sternum) {
        double edge = RingMesh.edgeLengthFor(this::count, vertices);
        List<Structure> structures = new ArrayList<>();
        for (Cartilage cartilage : cartilages) {
            structures.add(new Structure(
                    VirtualThorax.sided("costal_cartilage", cartilage.level(), cartilage.side()),
                    StructureKind.COSTAL_CARTILAGE,
                    cartilage.level(),
                    cartilage.side(),
                    mesh(cartilage, edge)));
        }
        Tube[] bars = bars(edge);
        structures.add(part("sternum_manubrium", sternum.manubrium(bars[0])));
        structures.add(part("sternum_body", sternum.body(bars[1])));
        structures.add(part("sternum_xiphoid", sternum.xiphoid(bars[2])));
        return structures;
    }

    private static Structure part(String name, TriangleMesh mesh) {
        return new Structure(name, StructureKind.STERNUM, 0, Side.MIDLINE, mesh);
    }

    private Tube[] bars(double edge) {
        VirtualThoraxParameters.Sternum sternum = parameters.sternum();
        return new Tube[] {
            bar(110, sternum.manubriumMm(), edge), bar(86, sternum.bodyMm(), edge), bar(36, sternum.xiphoidMm(), edge)
        };
    }

    private static Tube bar(double perimeter, double length, double edge) {
        int around = 2 * Math.max(4, (int) Math.round(perimeter / edge / 2));
        return new Tube(around, Math.max(4, (int) Math.round(length / edge)), 3, CAP_MM);
    }

    private Tube tube(Polyline course, double edge) {
        double h = parameters.cartilages().heightMm();
        double d = parameters.cartilages().thicknessMm();
        int around = Math.max(6, (int) Math.round(Math.PI / 2 * (h + d) / edge));
        return new Tube(around, Math.max(3, (int) Math.round(course.length() / edge)), SECTION_FLATNESS, CAP_MM);
    }

    private int count(double edge) {
        int total = 0;
        for (Cartilage cartilage : cartilages) {
            total += tube(cartilage.course(), edge).vertexCount();
        }
        for (Tube bar : bars(edge)) {
            total += bar.vertexCount();
        }
        return total;
    }

    private TriangleMesh mesh(Cartilage cartilage, double edge) {
        VirtualThoraxParameters.Cartilages m = parameters.cartilages();
        double ribHeight = parameters.ribs().heightMm() * 0.92;
        double ribThickness = parameters.ribs().thicknessMm() * 0.9;
        double slender = cartilage.level() == 1 ? 1.15 : 1;
        double endShare = cartilage.level() >= 8 ? 0.6 : 0.75;
        return tube(cartilage.course(), edge)
                .mesh(
                        cartilage.course(),
                        t -> {
                            double in = SmoothBlends.smoothstep(t / 0.15);
                            double out = 1 - (1 - endShare) * SmoothBlends.smoothstep((t - 0.6) / 0.4);
                            return new Tube.Section(
                                    (ribHeight + (m.heightMm() * slender - ribHeight) * in) / 2 * out,
                                    (ribThickness + (m.thicknessMm() - ribThickness) * in) / 2 * out);
                        },
                        wall::boneBedNormal);
    }
}
