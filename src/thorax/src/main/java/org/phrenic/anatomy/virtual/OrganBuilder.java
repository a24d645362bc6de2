package org.phrenic.anatomy.virtual;

import static org.phrenic.anatomy.virtual.ChestWallShape.column;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.organ.OrganShapes;
import org.phrenic.anatomy.virtual.organ.OrganSpace;
import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.ProfileCurve;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.anatomy.virtual.shape.Tube;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.TriangleMesh;

/** Generates the organs and vessels of a virtual body, and its pleura. */
final class OrganBuilder {
    /** Distance from the inner chest wall to organs of the chest, mm. */
    private static final double CHEST_INSET_MM = 2;

    /** The internal mammary vessels lie on the wall, between pleura and cartilages. */
    private static final double MAMMARY_OFF_WALL_MM = 0.4;
    /** The superior epigastric vessels lie in the rectus sheath, behind and in the muscle. */
    private static final double EPIGASTRIC_OFF_WALL_MM = 8;

    /** The pleura reaches farther into the corners beside spine and sternum than the lung. */
    private static final double PLEURA_EDGE_MM = 4;

    /** Radius of the edge between lung and chest wall of what lies in the mediastinum. */
    private static final double MEDIASTINUM_EDGE_MM = 8;

    private static final int STEPS = 40;
    private static final double HALF_WIDTH_MM = 2.5;
    private static final double HALF_THICKNESS_MM = 0.9;
    private static final Tube VESSEL = new Tube(8, 40, 2, 2);

    private final VirtualThoraxParameters parameters;
    private final VirtualThoraxParameters.Organs organs;
    private final ChestWallShape wall;
    private final DiaphragmShape dome;

    OrganBuilder(VirtualThoraxParameters parameters) {
        this.parameters = parameters;
        organs = parameters.organs();
        wall = new ChestWallShape(parameters.chestWall(), new Spine(parameters.spine()));
        dome = new DiaphragmShape(parameters.diaphragm(), wall);
    }

    List<Structure> build() {
        List<Structure> all = new ArrayList<>(OrganShapes.generate(organs.parts(), cavities(), organs.gapMm()));
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            all.add(vessel("internal_mammary_vessels", side, organs.internalMammary(), MAMMARY_OFF_WALL_MM));
            all.add(vessel("superior_epigastric_vessels", side, organs.superiorEpigastric(), EPIGASTRIC_OFF_WALL_MM));
            all.add(new Structure(name("pleura", side), StructureKind.PLEURA, 0, side, pleura(side)));
        }
        return List.copyOf(all);
    }

    private static String name(String stem, Side side) {
        return stem + (side == Side.LEFT ? "_L" : "_R");
    }

    /** Vessels that run down along the front wall: an artery with its veins in one flat tube. */
    private Structure vessel(String stem, Side side, List<ImmutableDoubleArray> rows, double offWallMm) {
        ProfileCurve across = new ProfileCurve(column(rows, 0), column(rows, 1));
        double bottom = rows.get(0).at(0);
        double top = rows.get(rows.size() - 1).at(0);
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i <= STEPS; i++) {
            double z = bottom + (top - bottom) * i / STEPS;
            double x = side.sign() * across.at(z);
            points.add(wall.boneBed(frontAzimuth(x, z), z, offWallMm));
        }
        TriangleMesh mesh = VESSEL.mesh(
                new Polyline(points), t -> new Tube.Section(HALF_WIDTH_MM, HALF_THICKNESS_MM), wall::boneBedNormal);
        return new Structure(name(stem, side), StructureKind.VESSEL, 0, side, mesh);
    }

    /** Azimuth of the point of the front wall at a distance from the midplane, by bisection. */
    private double frontAzimuth(double x, double z) {
        double inner = Math.PI;
        double outer = Math.PI / 2;
        for (int i = 0; i < 30; i++) {
            double middle = (inner + outer) / 2;
            if (wall.boneBed(middle, z, 0)[0] < Math.abs(x)) {
                inner = middle;
            } else {
                outer = middle;
            }
        }
        return Math.signum(x) * inner;
    }

    private TriangleMesh pleura(Side side) {
        List<ImmutableDoubleArray> rows = organs.pleuralReflection();
        ProfileCurve line = new ProfileCurve(column(rows, 0), column(rows, 1));
        VirtualThoraxParameters.Lungs atWall = parameters.lungs().withWallInset(organs.pleuraInsetMm());
        return lung(side, atWall, PLEURA_EDGE_MM).pleura(azimuth -> line.at(StrictMath.toDegrees(azimuth)));
    }

    private LungShape lung(Side side, VirtualThoraxParameters.Lungs measures, double edgeMm) {
        return new LungShape(measures, parameters.diaphragm(), wall, dome, side, edgeMm);
    }

    private OrganSpace.Cavities cavities() {
        double half = parameters.diaphragm().muscleMm() / 2;
        double belowMm = half + parameters.liver().diaphragmGapMm();
        double aboveMm = half + parameters.lungs().diaphragmGapMm();
        ImplicitSurface right =
                lung(Side.RIGHT, parameters.lungs(), LungShape.COSTAL_EDGE_MM).region();
        ImplicitSurface left =
                lung(Side.LEFT, parameters.lungs(), LungShape.COSTAL_EDGE_MM).region();
        ImplicitSurface mediastinum = (x, y, z) -> SmoothBlends.roundIntersection(
                wall.at(x, y, z) + CHEST_INSET_MM, -(x < 0 ? right : left).at(x, y, z), MEDIASTINUM_EDGE_MM);
        return new OrganSpace.Cavities(
                (x, y, z) -> dome.at(x, y, z) + belowMm,
                new LiverShape(parameters, wall, dome).visceralRegion(),
                mediastinum,
                (x, y, z) -> aboveMm - dome.at(x, y, z));
    }
}
