//! Render settings (section 5), in their two layouts.

use crate::chunk::{Reader, Writer};
use crate::values::{read_colour, write_colour};
use crate::{Error, Result, typecode};

/// How a model is rendered. Colours are red, green, blue, alpha; numbers without names are those of archives.
#[derive(Debug, Clone, PartialEq)]
pub struct RenderSettings {
    /// Whether the image has its own size, not that of a view.
    pub custom_size: bool,
    /// The width and height of the image in pixels.
    pub size: [i32; 2],
    /// Pixels an inch.
    pub resolution: f64,
    /// The unit the size is shown in.
    pub size_units: i32,
    /// The colour of ambient light.
    pub ambient: [u8; 4],
    /// What the background is: 0 one colour, 1 an image, 2 two colours, 3 an environment.
    pub background: i32,
    /// The colour of the background, at the top when there are two.
    pub background_colour: [u8; 4],
    /// The colour of the background at the bottom.
    pub background_bottom: [u8; 4],
    /// The image of the background.
    pub background_image: String,
    /// Hidden lights, depth cue, flat shade, back faces, points, curves, isocurves, mesh edges and annotations:
    /// whether each is rendered.
    pub renders: [bool; 9],
    /// Whether the image of the background is made to fit.
    pub scale_background: bool,
    /// Whether the background is transparent.
    pub transparent_background: bool,
    /// How edges are smoothed, how shadows are made, and their width and height.
    pub quality: [i32; 4],
    /// How far shadows are moved.
    pub shadow_offset: f64,
    /// Which view is rendered: 0 the current one, 1 a view, 2 a named view, 3 a snapshot.
    pub source: i32,
    /// The names of that view, named view and snapshot.
    pub source_names: [String; 3],
    /// Whether the image has the proportions of the view.
    pub keep_aspect: bool,
}

impl Default for RenderSettings {
    fn default() -> Self {
        Self {
            custom_size: false,
            size: [800, 600],
            resolution: 72.0,
            size_units: 8,
            ambient: [0, 0, 0, 255],
            background: 0,
            background_colour: [160, 160, 160, 255],
            background_bottom: [160, 160, 160, 255],
            background_image: String::new(),
            renders: [true, false, false, true, false, false, false, false, false],
            scale_background: false,
            transparent_background: false,
            quality: [1, 1, 1000, 1000],
            shadow_offset: 0.75,
            source: 0,
            source_names: [const { String::new() }; 3],
            keep_aspect: false,
        }
    }
}

const WHAT: &str = "render settings";
/// The version number that the older layout begins with.
const OLD: i32 = 103;

impl RenderSettings {
    pub(crate) fn read(body: &mut Reader<'_>) -> Result<Self> {
        if body.peek_typecode() == Some(typecode::ANONYMOUS) {
            Self::read_new(body)
        } else {
            Self::read_old(body)
        }
    }

    fn read_old(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let version = body.i32(WHAT)?;
        if !(100..200).contains(&version) {
            return Err(Error::malformed(offset, WHAT, format!("version {version} is not known")));
        }
        let mut settings = Self {
            custom_size: body.i32(WHAT)? != 0,
            size: [body.i32(WHAT)?, body.i32(WHAT)?],
            ambient: read_colour(body, WHAT)?,
            background: body.i32(WHAT)?,
            background_colour: read_colour(body, WHAT)?,
            background_image: body.string(WHAT)?,
            ..Self::default()
        };
        for renders in &mut settings.renders {
            *renders = body.i32(WHAT)? != 0;
        }
        for quality in &mut settings.quality {
            *quality = body.i32(WHAT)?;
        }
        settings.shadow_offset = body.f64(WHAT)?;
        if version >= 101 {
            settings.resolution = body.f64(WHAT)?;
            settings.size_units = body.i32(WHAT)?;
        }
        if version >= 102 {
            settings.background_bottom = read_colour(body, WHAT)?;
        }
        if version >= 103 {
            settings.scale_background = body.bool(WHAT)?;
        }
        Ok(settings)
    }

    fn read_new(body: &mut Reader<'_>) -> Result<Self> {
        let (mut chunk, minor) = body.versioned_1(WHAT)?;
        let r = &mut chunk;
        let mut settings = Self {
            custom_size: r.bool(WHAT)?,
            size: [r.i32(WHAT)?, r.i32(WHAT)?],
            resolution: r.f64(WHAT)?,
            size_units: r.i32(WHAT)?,
            ambient: read_colour(r, WHAT)?,
            background: r.i32(WHAT)?,
            background_colour: read_colour(r, WHAT)?,
            background_bottom: read_colour(r, WHAT)?,
            background_image: r.string(WHAT)?,
            ..Self::default()
        };
        for renders in &mut settings.renders {
            *renders = r.bool(WHAT)?;
        }
        settings.scale_background = r.bool(WHAT)?;
        settings.transparent_background = r.bool(WHAT)?;
        for quality in &mut settings.quality {
            *quality = r.i32(WHAT)?;
        }
        settings.shadow_offset = r.f64(WHAT)?;
        if minor >= 1 {
            // Focal blur, which views have now.
            r.take(32, WHAT)?;
        }
        if minor >= 2 {
            settings.source = r.i32(WHAT)?;
            for name in &mut settings.source_names {
                *name = r.string(WHAT)?;
            }
        }
        if minor >= 3 {
            settings.keep_aspect = r.bool(WHAT)?;
        }
        chunk.finish();
        Ok(settings)
    }

    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        if w.version().archive < 60 { self.write_old(w) } else { self.write_new(w) }
    }

    fn write_old(&self, w: &mut Writer) -> Result<()> {
        w.i32(OLD);
        w.i32(i32::from(self.custom_size));
        self.size.iter().for_each(|number| w.i32(*number));
        write_colour(self.ambient, w);
        w.i32(self.background);
        write_colour(self.background_colour, w);
        w.string(&self.background_image)?;
        self.renders.iter().for_each(|renders| w.i32(i32::from(*renders)));
        self.quality.iter().for_each(|number| w.i32(*number));
        w.f64(self.shadow_offset);
        w.f64(self.resolution);
        w.i32(self.size_units);
        write_colour(self.background_bottom, w);
        w.bool(self.scale_background);
        Ok(())
    }

    fn write_new(&self, w: &mut Writer) -> Result<()> {
        w.versioned(1, 3, |w| {
            w.bool(self.custom_size);
            self.size.iter().for_each(|number| w.i32(*number));
            w.f64(self.resolution);
            w.i32(self.size_units);
            write_colour(self.ambient, w);
            w.i32(self.background);
            write_colour(self.background_colour, w);
            write_colour(self.background_bottom, w);
            w.string(&self.background_image)?;
            self.renders.iter().for_each(|renders| w.bool(*renders));
            w.bool(self.scale_background);
            w.bool(self.transparent_background);
            self.quality.iter().for_each(|number| w.i32(*number));
            w.f64(self.shadow_offset);
            // No focal blur.
            w.i32(0);
            [100.0, 64.0, 0.1].iter().for_each(|number| w.f64(*number));
            w.i32(10);
            w.i32(self.source);
            self.source_names.iter().try_for_each(|name| w.string(name))?;
            w.bool(self.keep_aspect);
            Ok(())
        })
    }
}
