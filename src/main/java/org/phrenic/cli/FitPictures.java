package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.format.ReportDocument.Picture;
import org.phrenic.geometry.DistanceSummary;
import org.phrenic.scene.ColourField;
import org.phrenic.scene.ColourScale;
import org.phrenic.scene.FieldPicture;
import org.phrenic.scene.NoGraphicsException;
import org.phrenic.scene.Shot;
import org.phrenic.scene.View;
import org.phrenic.study.fit.FitDistances;
import org.phrenic.study.fit.FitResult;

/** Each target's part of the body in colours of its distance, at end-expiration and as fitted, in one scale. */
final class FitPictures {
    private static final int SIZE = 640;
    private static final double[] RANGES = {2, 3, 5, 10, 15, 20, 30, 50, 100};

    private FitPictures() {}

    /** Draws all into a folder; none, with a line that says why, where nothing here draws. */
    static List<Picture> draw(FitResult result, Path folder, PrintWriter err) {
        List<Picture> pictures = new ArrayList<>();
        try {
            for (FitResult.TargetResult target : result.targets()) {
                if (!target.target().isPairs()) {
                    draw(target, folder, pictures);
                }
            }
        } catch (NoGraphicsException none) {
            err.println("The report has no pictures: " + none.getMessage());
            return List.of();
        }
        return pictures;
    }

    private static void draw(FitResult.TargetResult target, Path folder, List<Picture> pictures)
            throws NoGraphicsException {
        ColourScale scale = scale(target.initial().summary());
        View[] views = target.target().part().isBase()
                ? new View[] {View.INFERIOR}
                : new View[] {View.ANTERIOR, View.INFERIOR};
        for (View view : views) {
            one(target.initial(), target.target().name(), "end-expiration", view, scale, folder, pictures);
            one(target.residual(), target.target().name(), "fitted", view, scale, folder, pictures);
        }
    }

    /** Colours from 0 to a round number that few distances exceed. */
    static ColourScale scale(DistanceSummary distances) {
        double most = distances.percentile95();
        double round = RANGES[RANGES.length - 1];
        for (int i = RANGES.length - 1; i >= 0 && RANGES[i] >= most; i--) {
            round = RANGES[i];
        }
        return ColourScale.magnitude(round, ColourField.DISTANCE.unit());
    }

    private static void one(
            FitDistances distances,
            String name,
            String state,
            View view,
            ColourScale scale,
            Path folder,
            List<Picture> pictures)
            throws NoGraphicsException {
        String file = name + "_" + state + "_" + view.label() + ".png";
        String title = name + ", " + state;
        try (FieldPicture drawn = FieldPicture.open(distances.model(), distances.toTarget())) {
            drawn.write(folder.resolve(file), Shot.of(view, SIZE, SIZE, title), scale);
        }
        pictures.add(new Picture(file, title + " seen from " + view.label(), title));
    }
}
