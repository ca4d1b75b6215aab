"""Files around random geometry: tables, attributes, settings, views, all that rhino3dm's interface can set."""

import uuid

import rhino3dm as r

from .common import SHARED
from .generated_models import Maker, given

NAMES = ("", "plain", "Größe", "слой", "図面 層", "🦗🦗", " edges ", "a/b::c", "x" * 200)
FAMILIES = ("curves", "surfaces", "extrusions", "breps", "meshes", "clouds", "lights", "dots", "blocks")
SEEDED = (r.Hatch, r.AnnotationBase, r.SubD, r.Mesh, r.Brep, r.Extrusion)


def colour(maker):
    return (*(maker.random.randint(0, 255) for _ in range(3)), 255)


def add_layers(file, maker):
    ids = []
    for i in range(8):
        layer = r.Layer()
        layer.Name = f"{maker.random.choice(NAMES)} {i}"
        layer.Color, layer.PlotColor = colour(maker), colour(maker)
        layer.PlotWeight = maker.random.choice([0.0, -1.0, 0.35])
        layer.Visible, layer.Locked = maker.random.random() < 0.6, maker.random.random() < 0.3
        layer.Expanded = maker.random.random() < 0.5
        layer.IgesLevel = maker.random.choice([-1, 1, 255])
        layer.LinetypeIndex = maker.random.randint(-1, 2)
        layer.RenderMaterialIndex = maker.random.randint(-1, 3)
        if ids and maker.random.random() < 0.6:
            layer.ParentLayerId = maker.random.choice(ids)
        if i % 3 == 2:
            layer.SetPersistentVisibility(bool(i % 2))
            layer.SetPersistentLocking(not i % 2)
            layer.SetPerViewportColor(uuid.UUID(int=77 + i), colour(maker))
        layer.SetUserString("schlüssel", maker.random.choice(NAMES))
        ids.append(file.Layers[file.Layers.Add(layer)].Id)


def add_linetypes(file, maker):
    for name in ("dashes", "Strich·Punkt"):
        linetype = r.Linetype()
        linetype.Name = name
        for i in range(maker.random.randint(2, 6)):
            linetype.AppendSegment(maker.random.uniform(0.1, 5), i % 2 == 0)
        file.Linetypes.Add(given(linetype))


def add_materials(file, maker):
    for i in range(5):
        material = r.Material()
        material.Name = f"{maker.random.choice(NAMES)} {i}"
        for name in ("Diffuse", "Ambient", "Emission", "Specular", "Reflection", "Transparent"):
            setattr(material, f"{name}Color", colour(maker))
        for name in ("Transparency", "Shine", "Reflectivity", "IndexOfRefraction", "ReflectionGlossiness",
                     "RefractionGlossiness", "FresnelIndexOfRefraction"):
            setattr(material, name, maker.random.random())
        material.FresnelReflections = bool(i & 1)
        material.DisableLighting = bool(i & 2)
        if i & 1:
            material.SetBitmapTexture("wood ω.png")
            material.SetBumpTexture("bump.jpg")
        if i == 3:
            texture = r.Texture()
            texture.FileName = "/tmp/environment.hdr"
            material.SetEnvironmentTexture(texture)
            material.SetTransparencyTexture("t.png")
        if i == 4:
            material.ToPhysicallyBased()
            for name in ("Metallic", "Roughness", "Clearcoat", "Opacity", "Subsurface", "Sheen"):
                setattr(material.PhysicallyBased, name, maker.random.random())
        file.Materials.Add(material)


def add_styles(file, maker):
    for i in range(3):
        style = r.DimensionStyle()
        style.Name = f"{maker.random.choice(NAMES)} style {i}"
        for name in ("ArrowLength", "TextHeight", "ExtensionLineExtension", "ExtensionLineOffset", "CentermarkSize",
                     "TextGap", "LeaderArrowLength", "LengthFactor", "AlternateLengthFactor", "DimensionScale",
                     "BaselineSpacing", "ToleranceUpperValue", "StackHeightScale", "LeaderLandingLength"):
            setattr(style, name, maker.random.uniform(0.1, 5))
        style.SuppressArrow1, style.DrawForward, style.TextUnderlined = bool(i & 1), bool(i & 2), i == 2
        style.FixedExtensionLengthOn, style.LeaderHasLanding = i == 1, i != 1
        style.Font = r.Font("Courier New")
        file.DimStyles.Add(given(style))


def add_settings(file, maker):
    settings = file.Settings
    settings.ModelUnitSystem = maker.random.choice([u for name, u in r.UnitSystem.__members__.items()
                                                    if name not in ("None", "Unset")])
    settings.PageUnitSystem = maker.random.choice([r.UnitSystem.Inches, r.UnitSystem.Millimeters])
    for space in ("Model", "Page"):
        setattr(settings, f"{space}AbsoluteTolerance", maker.random.uniform(1e-6, 0.1))
        setattr(settings, f"{space}AngleToleranceRadians", maker.random.uniform(1e-4, 0.1))
        setattr(settings, f"{space}RelativeTolerance", maker.random.uniform(1e-4, 0.1))
    settings.ModelBasePoint = maker.point()
    settings.ModelUrl = "https://example.org/größe"
    anchor = settings.EarthAnchorPoint
    anchor.Name, anchor.Description = "Zürich", "Bürkliplatz"
    anchor.EarthBasepointLatitude, anchor.EarthBasepointLongitude = 47.3667, 8.55
    anchor.EarthBasepointElevation = 408.0
    anchor.ModelBasePoint = maker.point()
    settings.EarthAnchorPoint = anchor
    render = settings.RenderSettings
    render.AmbientLight, render.BackgroundColorTop, render.BackgroundColorBottom = (colour(maker) for _ in range(3))
    for name in ("DepthCue", "FlatShade", "RenderAnnotations", "RenderBackFaces", "RenderCurves", "RenderPoints",
                 "RenderIsoParams", "RenderMeshEdges", "UseHiddenLights", "TransparentBackground"):
        setattr(render, name, maker.random.random() < 0.5)
    render.ImageDpi = 300.0
    file.ApplicationName, file.ApplicationUrl = "Katydid größe", "https://example.org"
    file.ApplicationDetails = "details 詳細"
    file.StartSectionComments = "comments in front, größe"
    file.Revision = maker.random.randint(2, 99)
    file.Strings["section\\entry"] = "größe"
    file.Strings["plain 🦗"] = "x" * 400


def add_views(file, maker):
    for i, name in enumerate(("Perspective", "Draufsicht", "図")):
        view = r.ViewInfo()
        view.Name = name
        port = r.ViewportInfo.DefaultTop() if i == 1 else r.ViewportInfo.DefaultPerspective()
        port.SetCameraLocation(maker.point(50))
        port.SetScreenPort((0, 0, 800 + i, 600, 0, 1))
        view.Viewport = port
        view.FocalBlurDistance, view.ShowWallpaperInGrayScale = 12.5 + i, bool(i & 1)
        (file.NamedViews if i == 2 else file.Views).Add(view)


def attributes(file, maker):
    a = r.ObjectAttributes()
    a.Name, a.Url = maker.random.choice(NAMES), maker.random.choice(["", "https://example.org/ü"])
    a.LayerIndex = maker.random.randrange(max(1, len(file.Layers)))
    a.MaterialIndex, a.LinetypeIndex = maker.random.randint(-1, 4), maker.random.randint(-1, 2)
    for name, kind in (("ColorSource", r.ObjectColorSource), ("MaterialSource", r.ObjectMaterialSource),
                       ("LinetypeSource", r.ObjectLinetypeSource), ("PlotColorSource", r.ObjectPlotColorSource),
                       ("PlotWeightSource", r.ObjectPlotWeightSource), ("ObjectDecoration", r.ObjectDecoration)):
        setattr(a, name, maker.random.choice(list(kind.__members__.values())))
    a.ObjectColor, a.PlotColor = colour(maker), colour(maker)
    a.PlotWeight, a.WireDensity = maker.random.choice([0.0, 0.5]), maker.random.choice([-1, 0, 1, 5])
    a.Visible = maker.random.random() < 0.8
    a.CastsShadows, a.ReceivesShadows = maker.random.random() < 0.5, maker.random.random() < 0.5
    a.DisplayOrder = maker.random.choice([0, 0, -3, 7])
    a.ActiveSpace = maker.random.choice([r.ActiveSpace.ModelSpace, r.ActiveSpace.PageSpace])
    if maker.random.random() < 0.3:
        a.ViewportId = uuid.UUID(int=maker.random.getrandbits(128))
    for group in range(maker.random.randint(0, 3)):
        a.AddToGroup(group)
    for key in NAMES[1:maker.random.randint(1, 4)]:
        a.SetUserString(key, maker.random.choice(NAMES))
    return a


def add_blocks(file, maker):
    """Definitions that refer to each other, and references to them."""
    inner = None
    for i in range(3):
        members = [*maker.curves()[:3], r.Point(maker.point())]
        if inner is not None:
            members.append(r.InstanceReference(inner, r.Transform.Translation(1, 2, i)))
        index = file.InstanceDefinitions.Add(f"block {i} größe", "description", "https://example.org", "tag",
                                             maker.point(), tuple(members),
                                             tuple(attributes(file, maker) for _ in members))
        inner = file.InstanceDefinitions.FindIndex(index).Id
        form = r.Transform.Rotation(maker.random.random(), maker.vector(), maker.point())
        file.Objects.AddInstanceObject(r.InstanceReference(inner, form), attributes(file, maker))


def seeds(maker, limit=3):
    """Objects of classes that the interface cannot make from nothing, out of real files, moved and named anew."""
    found, held = {}, []
    for path in sorted(SHARED.glob("*.3dm")):
        if path.stat().st_size > 100_000:
            continue
        file = r.File3dm.Read(str(path))
        held.append(file)
        for entry in file.Objects:
            geometry = entry.Geometry
            if isinstance(geometry, SEEDED):
                kept = found.setdefault(type(geometry).__name__, [])
                if len(kept) < limit:
                    copy = geometry.Duplicate()
                    if copy is not None:
                        kept.append(copy)
    return [maker.texts(maker.moved(geometry)) for kept in found.values() for geometry in kept]


def document(family, geometry, maker):
    """A file of the geometry, with every table filled."""
    file = r.File3dm()
    add_linetypes(file, maker)
    add_materials(file, maker)
    add_layers(file, maker)
    add_styles(file, maker)
    for name in NAMES[1:5]:
        group = r.Group()
        group.Name = name
        file.Groups.Add(given(group))
    add_settings(file, maker)
    add_views(file, maker)
    if family == "blocks":
        add_blocks(file, maker)
    for item in geometry:
        file.Objects.Add(item, attributes(file, maker))
    return file


def documents(seed):
    """The files of a seed by their names."""
    for family in FAMILIES:
        maker = Maker(seed)
        yield family, document(family, getattr(maker, family)(), maker)
    maker = Maker(seed)
    geometry = seeds(maker)
    if geometry:
        yield "seeded", document("seeded", geometry, maker)
