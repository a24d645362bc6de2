package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.List;
import org.phrenic.document.YamlMap;

/** A setting that is on or off. */
public final class SwitchSetting extends Setting<Boolean> {
    private final boolean defaultValue;

    SwitchSetting(Declaration declaration, boolean defaultValue) {
        super(declaration);
        this.defaultValue = defaultValue;
    }

    @Override
    public List<String> options() {
        return List.of("true", "false");
    }

    @Override
    public Boolean defaultValue(SettingValues values) {
        return defaultValue;
    }

    @Override
    public Boolean read(YamlMap yaml, Path folder) {
        return yaml.flag(key());
    }
}
