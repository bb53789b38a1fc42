-- | All tests. Every module of this folder whose name ends in Spec is listed here ("StructureSpec" sees to it).
module Main
  ( main,
  )
where

import qualified Dioptre.Command.CommandSpec
import qualified Dioptre.Files.CounterSpec
import qualified Dioptre.Files.DescriptorSpec
import qualified Dioptre.Files.FaultSpec
import qualified Dioptre.Files.NumberSpec
import qualified Dioptre.Files.SearchSpec
import qualified Dioptre.Files.TemporarySpec
import qualified Dioptre.Files.WholeSpec
import qualified Dioptre.Geometry.BoundsSpec
import qualified Dioptre.Geometry.CapSpec
import qualified Dioptre.Geometry.ConeSpec
import qualified Dioptre.Geometry.CubeSpec
import qualified Dioptre.Geometry.CylinderSpec
import qualified Dioptre.Geometry.DiskSpec
import qualified Dioptre.Geometry.LensSpec
import qualified Dioptre.Geometry.PlacementSpec
import qualified Dioptre.Geometry.PlaneSpec
import qualified Dioptre.Geometry.PreparedSpec
import qualified Dioptre.Geometry.SphereSpec
import qualified Dioptre.Geometry.TorusSpec
import qualified Dioptre.Geometry.TriangleSpec
import qualified Dioptre.Geometry.TubeSpec
import qualified Dioptre.Geometry.UvSpec
import qualified Dioptre.Light.ColourSpec
import qualified Dioptre.Light.IlluminationSpec
import qualified Dioptre.Light.LightSpec
import qualified Dioptre.Light.MaterialSpec
import qualified Dioptre.Light.WaveSpec
import qualified Dioptre.Light.WavelengthSpec
import qualified Dioptre.Math.QuarticSpec
import qualified Dioptre.Math.RootsSpec
import qualified Dioptre.Math.TransformSpec
import qualified Dioptre.Math.VectorSpec
import qualified Dioptre.Optics.ReflectionSpec
import qualified Dioptre.Optics.RefractionSpec
import qualified Dioptre.Picture.ByteSpec
import qualified Dioptre.Picture.PngSpec
import qualified Dioptre.Picture.TextureFileSpec
import qualified Dioptre.PictureSpec
import qualified Dioptre.Render.RowSpec
import qualified Dioptre.Render.SamplingSpec
import qualified Dioptre.Render.ShadeSpec
import qualified Dioptre.Render.StageSpec
import qualified Dioptre.Render.TextureSpec
import qualified Dioptre.Render.ViewSpec
import qualified Dioptre.Render.WorldSpec
import qualified Dioptre.RenderSpec
import qualified Dioptre.Scene.CameraSpec
import qualified Dioptre.Scene.CheckSpec
import qualified Dioptre.Scene.ConfigurationSpec
import qualified Dioptre.Scene.FormSpec
import qualified Dioptre.Scene.LightsSpec
import qualified Dioptre.Scene.MaterialsSpec
import qualified Dioptre.Scene.RaytracerSpec
import qualified Dioptre.Scene.ShapesSpec
import qualified Dioptre.SceneSpec
import qualified Dioptre.Source.LanguageSpec
import qualified Dioptre.Source.MessageSpec
import qualified Dioptre.Source.ReportSpec
import qualified Dioptre.Source.TextSpec
import qualified Dioptre.Syntax.GrammarSpec
import qualified Dioptre.Syntax.KeywordSpec
import qualified Dioptre.Syntax.PrintSpec
import qualified Dioptre.Syntax.SpellingSpec
import qualified Dioptre.Syntax.ValueSpec
import GHC.IO.Encoding (mkTextEncoding, setFileSystemEncoding, setLocaleEncoding, utf8)
import qualified GoldenSpec
import qualified StructureSpec
import System.IO (hSetEncoding, stderr, stdout)
import Test.Hspec (Spec, describe, hspec)

main :: IO ()
main = do
  -- As the program does, first thing.
  mkTextEncoding "UTF-8//ROUNDTRIP" >>= setFileSystemEncoding
  setLocaleEncoding utf8
  mapM_ (`hSetEncoding` utf8) [stdout, stderr]
  hspec specs

specs :: Spec
specs = do
  describe "The house" StructureSpec.spec
  describe "Dioptre.Command.Command" Dioptre.Command.CommandSpec.spec
  describe "Dioptre.Files.Counter" Dioptre.Files.CounterSpec.spec
  describe "Dioptre.Files.Descriptor" Dioptre.Files.DescriptorSpec.spec
  describe "Dioptre.Files.Fault" Dioptre.Files.FaultSpec.spec
  describe "Dioptre.Files.Number" Dioptre.Files.NumberSpec.spec
  describe "Dioptre.Files.Search" Dioptre.Files.SearchSpec.spec
  describe "Dioptre.Files.Temporary" Dioptre.Files.TemporarySpec.spec
  describe "Dioptre.Files.Whole" Dioptre.Files.WholeSpec.spec
  describe "Dioptre.Geometry.Bounds" Dioptre.Geometry.BoundsSpec.spec
  describe "Dioptre.Geometry.Cap" Dioptre.Geometry.CapSpec.spec
  describe "Dioptre.Geometry.Cone" Dioptre.Geometry.ConeSpec.spec
  describe "Dioptre.Geometry.Cube" Dioptre.Geometry.CubeSpec.spec
  describe "Dioptre.Geometry.Cylinder" Dioptre.Geometry.CylinderSpec.spec
  describe "Dioptre.Geometry.Disk" Dioptre.Geometry.DiskSpec.spec
  describe "Dioptre.Geometry.Lens" Dioptre.Geometry.LensSpec.spec
  describe "Dioptre.Geometry.Placement" Dioptre.Geometry.PlacementSpec.spec
  describe "Dioptre.Geometry.Plane" Dioptre.Geometry.PlaneSpec.spec
  describe "Dioptre.Geometry.Prepared" Dioptre.Geometry.PreparedSpec.spec
  describe "Dioptre.Geometry.Sphere" Dioptre.Geometry.SphereSpec.spec
  describe "Dioptre.Geometry.Torus" Dioptre.Geometry.TorusSpec.spec
  describe "Dioptre.Geometry.Triangle" Dioptre.Geometry.TriangleSpec.spec
  describe "Dioptre.Geometry.Tube" Dioptre.Geometry.TubeSpec.spec
  describe "Dioptre.Geometry.Uv" Dioptre.Geometry.UvSpec.spec
  describe "Dioptre.Light.Colour" Dioptre.Light.ColourSpec.spec
  describe "Dioptre.Light.Illumination" Dioptre.Light.IlluminationSpec.spec
  describe "Dioptre.Light.Light" Dioptre.Light.LightSpec.spec
  describe "Dioptre.Light.Material" Dioptre.Light.MaterialSpec.spec
  describe "Dioptre.Light.Wave" Dioptre.Light.WaveSpec.spec
  describe "Dioptre.Light.Wavelength" Dioptre.Light.WavelengthSpec.spec
  describe "Dioptre.Math.Quartic" Dioptre.Math.QuarticSpec.spec
  describe "Dioptre.Math.Roots" Dioptre.Math.RootsSpec.spec
  describe "Dioptre.Math.Transform" Dioptre.Math.TransformSpec.spec
  describe "Dioptre.Math.Vector" Dioptre.Math.VectorSpec.spec
  describe "Dioptre.Optics.Reflection" Dioptre.Optics.ReflectionSpec.spec
  describe "Dioptre.Optics.Refraction" Dioptre.Optics.RefractionSpec.spec
  describe "Dioptre.Picture.Byte" Dioptre.Picture.ByteSpec.spec
  describe "Dioptre.Picture.Png" Dioptre.Picture.PngSpec.spec
  describe "Dioptre.Picture.TextureFile" Dioptre.Picture.TextureFileSpec.spec
  describe "Dioptre.Picture" Dioptre.PictureSpec.spec
  describe "Dioptre.Render.Row" Dioptre.Render.RowSpec.spec
  describe "Dioptre.Render.Sampling" Dioptre.Render.SamplingSpec.spec
  describe "Dioptre.Render.Shade" Dioptre.Render.ShadeSpec.spec
  describe "Dioptre.Render.Stage" Dioptre.Render.StageSpec.spec
  describe "Dioptre.Render.Texture" Dioptre.Render.TextureSpec.spec
  describe "Dioptre.Render.View" Dioptre.Render.ViewSpec.spec
  describe "Dioptre.Render.World" Dioptre.Render.WorldSpec.spec
  describe "Dioptre.Render" Dioptre.RenderSpec.spec
  describe "Dioptre.Scene.Camera" Dioptre.Scene.CameraSpec.spec
  describe "Dioptre.Scene.Check" Dioptre.Scene.CheckSpec.spec
  describe "Dioptre.Scene.Configuration" Dioptre.Scene.ConfigurationSpec.spec
  describe "Dioptre.Scene.Form" Dioptre.Scene.FormSpec.spec
  describe "Dioptre.Scene.Lights" Dioptre.Scene.LightsSpec.spec
  describe "Dioptre.Scene.Materials" Dioptre.Scene.MaterialsSpec.spec
  describe "Dioptre.Scene.Raytracer" Dioptre.Scene.RaytracerSpec.spec
  describe "Dioptre.Scene.Shapes" Dioptre.Scene.ShapesSpec.spec
  describe "Dioptre.Scene" Dioptre.SceneSpec.spec
  describe "Dioptre.Source.Language" Dioptre.Source.LanguageSpec.spec
  describe "Dioptre.Source.Message" Dioptre.Source.MessageSpec.spec
  describe "Dioptre.Source.Report" Dioptre.Source.ReportSpec.spec
  describe "Dioptre.Source.Text" Dioptre.Source.TextSpec.spec
  describe "Dioptre.Syntax.Grammar" Dioptre.Syntax.GrammarSpec.spec
  describe "Dioptre.Syntax.Keyword" Dioptre.Syntax.KeywordSpec.spec
  describe "Dioptre.Syntax.Print" Dioptre.Syntax.PrintSpec.spec
  describe "Dioptre.Syntax.Spelling" Dioptre.Syntax.SpellingSpec.spec
  describe "Dioptre.Syntax.Value" Dioptre.Syntax.ValueSpec.spec
  describe "Pictures" GoldenSpec.spec
