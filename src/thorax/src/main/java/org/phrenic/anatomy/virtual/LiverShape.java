package org.phrenic.anatomy.virtual;

import org.phrenic.anatomy.virtual.shape.Clearance;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.MarchingTetrahedra;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.anatomy.virtual.shape.SurfaceRelaxation;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * The liver: the region below the abdominal face of the diaphragm, inside the chest wall and above the visceral
 * surface. The visceral surface is a plane that rises to the left and to the back; its height follows from the given
 * volume.
 */
final class LiverShape {
    private static final double EDGE_MM = 10;
    private static final double LEFT_END_MM = 14;
    private static final double GRID_MM = 9;
    private static final int SWEEPS = 6;

    private final VirtualThoraxParameters.Liver measures;
    private final VirtualThoraxParameters.Diaphragm diaphragm;
    private final ChestWallShape wall;
    private final DiaphragmShape dome;

    LiverShape(VirtualThoraxParameters parameters, ChestWallShape wall, DiaphragmShape dome) {
        measures = parameters.liver();
        diaphragm = parameters.diaphragm();
        this.wall = wall;
        this.dome = dome;
    }

    private double at(double x, double y, double z, double height) {
        double under = dome.at(x, y, z) + diaphragm.muscleMm() / 2 + measures.diaphragmGapMm();
        double region = SmoothBlends.roundIntersection(under, aboveVisceral(x, y, z, height), EDGE_MM);
        region = SmoothBlends.roundIntersection(region, beforeCut(x, y), LEFT_END_MM);
        return SmoothBlends.roundIntersection(region, x - measures.leftEndX(), LEFT_END_MM);
    }

    private double aboveVisceral(double x, double y, double z, double height) {
        double slopeX = measures.visceralSlope().at(0);
        double slopeY = measures.visceralSlope().at(1);
        double above = height + slopeX * x + slopeY * y - z;
        return above / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY);
    }

    private double beforeCut(double x, double y) {
        double cut = measures.backCut().at(1);
        return (y - measures.backCut().at(0) + cut * x) / Math.sqrt(1 + cut * cut);
    }

    /** The region above the visceral surface and before the cut behind the left lobe; below the diaphragm the liver. */
    ImplicitSurface visceralRegion() {
        double height = height();
        return (x, y, z) ->
                Math.max(aboveVisceral(x, y, z, height), Math.max(beforeCut(x, y), x - measures.leftEndX()));
    }

    TriangleMesh mesh() {
        double height = height();
        ImplicitSurface field = (x, y, z) -> at(x, y, z, height);
        TriangleMesh rough = MarchingTetrahedra.surface(field, low(), high(), GRID_MM);
        TriangleMesh even = SurfaceRelaxation.relax(rough, SWEEPS, v -> field);
        return Clearance.enforce(even, dome, -1, diaphragm.muscleMm() / 2 + measures.diaphragmGapMm());
    }

    private double[] low() {
        return Vectors.of(-wall.halfBreadth(60) - 5, -115, -110);
    }

    private double[] high() {
        return Vectors.of(measures.leftEndX() + 10, 105, diaphragm.right().at(2) + 10);
    }

    /** Height of the visceral surface at the axis, by bisection on the volume counted on a grid. */
    private double height() {
        double high = diaphragm.right().at(2);
        double low = high - 250;
        for (int i = 0; i < 9; i++) {
            double middle = (low + high) / 2;
            if (volume(middle) > measures.volumeMl() * 1000) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return (low + high) / 2;
    }

    private double volume(double height) {
        double step = 2 * GRID_MM;
        double[] low = low();
        double[] high = high();
        double volume = 0;
        for (double z = low[2]; z < high[2]; z += step) {
            for (double y = low[1]; y < high[1]; y += step) {
                for (double x = low[0]; x < high[0]; x += step) {
                    double inside = -at(x, y, z, height) / step + 0.5;
                    volume += Math.max(0, Math.min(1, inside));
                }
            }
        }
        return volume * step * step * step;
    }
}
