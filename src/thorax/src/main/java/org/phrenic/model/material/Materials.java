package org.phrenic.model.material;

import java.util.List;
import java.util.stream.Stream;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.parameter.ChoiceSetting;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;

/** The built-in materials. */
public final class Materials {
    /** Membrane under transdiaphragmatic pressure. */
    public static final TissueMaterial PHYSICAL = new PhysicalMaterial();
    /** Mass-spring model of Villard, Bourne and Bello 2009. */
    public static final TissueMaterial PAPER = new PaperMaterial();
    /** The same with the scheme, the step and the tendon of Villard, Bourne and Bello 2009. */
    public static final TissueMaterial PUBLISHED = new PublishedMaterial();

    /** All materials, the default first. */
    public static final List<TissueMaterial> ALL = List.of(PHYSICAL, PAPER, PUBLISHED);

    /** The setting that selects the material. */
    public static final ChoiceSetting<TissueMaterial> MATERIAL = Setting.named("material", "Material", Effect.ASSEMBLY)
            .describedAs("physical: a membrane with pressure and muscle that shortens. paper: the springs of"
                    + " Villard, Bourne and Bello 2009. published: the same with their scheme, midpoint Runge-Kutta.")
            .choice(ALL, TissueMaterial::label, values -> PHYSICAL);

    private Materials() {}

    /** The settings, parameters among them, that not every material uses. */
    public static List<Setting<?>> ofSome() {
        Stream<Setting<?>> all =
                ALL.stream().flatMap(m -> Stream.concat(m.parameters().stream(), m.settings().stream()));
        return all.distinct()
                .filter(setting -> !ALL.stream().allMatch(m -> m.uses(setting)))
                .toList();
    }

    /** Whether a setting has a use with a material, and not with others alone. */
    public static boolean isUsed(Setting<?> setting, TissueMaterial material) {
        return material.uses(setting) || !ofSome().contains(setting);
    }

    /** The parameters of all materials. */
    public static List<Parameter> parameters() {
        return ALL.stream().flatMap(m -> m.parameters().stream()).distinct().toList();
    }
}
